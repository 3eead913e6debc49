# Builds GoogleTest from source, so that the same tests run natively and as WebAssembly under Node.

set(HGP_GTEST_SOURCES "/usr/src/googletest" CACHE PATH "GoogleTest's source tree")
set(HGP_TEST_TIMEOUT 1800 CACHE STRING "Seconds after which a test program counts as hanging")
set(HGP_TEST_SET all CACHE STRING "Tests that are built and run: all, units or integration")
set_property(CACHE HGP_TEST_SET PROPERTY STRINGS all units integration)
if(NOT HGP_TEST_SET MATCHES "^(all|units|integration)$")
  message(FATAL_ERROR "HGP_TEST_SET is all, units or integration, not '${HGP_TEST_SET}'")
endif()

if(NOT TARGET gtest_main)
  if(NOT EXISTS "${HGP_GTEST_SOURCES}/CMakeLists.txt")
    message(FATAL_ERROR "GoogleTest's sources are not in ${HGP_GTEST_SOURCES}: run scripts/setup, "
      "or configure with -DHGP_TESTS=OFF")
  endif()
  set(INSTALL_GTEST OFF CACHE BOOL "" FORCE)
  set(BUILD_GMOCK OFF CACHE BOOL "" FORCE)
  set(gtest_disable_pthreads ${EMSCRIPTEN} CACHE BOOL "" FORCE)
  set(CMAKE_SUPPRESS_DEVELOPER_WARNINGS ON CACHE INTERNAL "" FORCE)
  add_subdirectory("${HGP_GTEST_SOURCES}" "${CMAKE_BINARY_DIR}/googletest" EXCLUDE_FROM_ALL)
  foreach(target gtest gtest_main)
    get_target_property(dirs ${target} INTERFACE_INCLUDE_DIRECTORIES)
    set_target_properties(${target} PROPERTIES INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${dirs}")
    # Without optimization and sanitizers: it is not our code, and then compiles in a fifth of the time.
    target_compile_options(${target} PRIVATE -O0
      $<$<CXX_COMPILER_ID:Clang>:-fno-sanitize=all>)
  endforeach()
endif()

# The test programs are CommonJS scripts, but the top-level package.json says "module".
if(EMSCRIPTEN)
  file(WRITE "${CMAKE_BINARY_DIR}/package.json" "{ \"type\": \"commonjs\" }\n")
endif()

# hgp_add_tests(field smooth_field_test.cpp … LINKS field [cut …] [EVERY_BUILD | INTEGRATION]
#               [DENSE] [MEASURES Suite.Name])
#
# Makes one test program, tests_<name>, with one ctest entry for all its tests, and another entry for a test that
# measures time, which tests/run.mjs runs even if nothing has changed. Tests read no files of this folder: their
# inputs are the program and the optional data. Sources may include
# "support/….h" from tests/. The environment variable HGP_SHARED_MESHES overrides the folder of optional data;
# tests that need it must call GTEST_SKIP() with a message if it is absent.
#
# Unit tests run once, where they find most: under sanitizers (HGP_TEST_SET=units). The release and
# WebAssembly builds run integration tests and those marked EVERY_BUILD, whose results may depend on
# the compiler or the processor, such as rounding. Other tests can still be built by name.
function(hgp_add_tests name)
  cmake_parse_arguments(T "EVERY_BUILD;INTEGRATION;DENSE" "MEASURES" "LINKS" ${ARGN})
  hgp_named_targets(links "tests of ${name}" ${T_LINKS})
  set(target tests_${name})
  add_executable(${target} ${T_UNPARSED_ARGUMENTS})
  hgp_compile_settings(${target})
  target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}/tests"
    "${PROJECT_SOURCE_DIR}/core")
  target_compile_definitions(${target} PRIVATE
    HGP_SHARED_MESHES_DEFAULT="${PROJECT_SOURCE_DIR}/../shared/meshes")
  target_link_libraries(${target} PRIVATE ${links} gtest_main)
  # One translation unit in every build: half of a test file's compile time is spent on GoogleTest and Eigen.
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 12)
  # Optimizing test code doubles its compile time without benefit, except for tests with their own dense linear
  # algebra (DENSE).
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  if(NOT T_DENSE)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Debug>:-O0>)
  endif()
  if(EMSCRIPTEN)
    # -O1, because binaryen's passes cost twenty seconds per link without benefit here.
    target_link_options(${target} PRIVATE -O1 -sALLOW_MEMORY_GROWTH=1 -sMAXIMUM_MEMORY=4GB
      -sNODERAWFS=1 -sEXIT_RUNTIME=1 --pre-js "${PROJECT_SOURCE_DIR}/cmake/node_environment.js")
  endif()
  set(kind units)
  if(T_INTEGRATION)
    set(kind integration)
  endif()
  if(NOT HGP_TEST_SET MATCHES "all|${kind}" AND NOT T_EVERY_BUILD)
    set_target_properties(${target} PROPERTIES EXCLUDE_FROM_ALL ON)
    return()
  endif()
  if(T_MEASURES)
    add_test(NAME ${name} COMMAND ${target} --gtest_brief=0 --gtest_filter=-${T_MEASURES})
    add_test(NAME ${name}_measures COMMAND ${target} --gtest_brief=0 --gtest_filter=${T_MEASURES})
    set_tests_properties(${name}_measures PROPERTIES TIMEOUT ${HGP_TEST_TIMEOUT} LABELS measures)
  else()
    add_test(NAME ${name} COMMAND ${target} --gtest_brief=0)
  endif()
  set_tests_properties(${name} PROPERTIES TIMEOUT ${HGP_TEST_TIMEOUT})
endfunction()
