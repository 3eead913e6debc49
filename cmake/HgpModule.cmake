# One static library per module of core/hgp, linked exactly to the modules that it may include.

# Adds a directory of this project if it exists.
function(hgp_add_directory dir)
  if(EXISTS "${PROJECT_SOURCE_DIR}/${dir}/CMakeLists.txt")
    add_subdirectory("${PROJECT_SOURCE_DIR}/${dir}" "${PROJECT_BINARY_DIR}/${dir}")
  endif()
endfunction()

# The compile settings of all our own code. No fused multiply-add: the exact predicates of verify/ rely on
# every operation being rounded once, and builds for different processors can be compared (decision 003).
function(hgp_compile_settings target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  # The order of Eigen's sums depends on vector widths and cache sizes. Without vectors and with fixed cache sizes it
  # is the same everywhere (decision 046). Performance-critical code has its own kernels.
  target_compile_definitions(${target} PRIVATE EIGEN_DONT_VECTORIZE EIGEN_NO_CPUID
    EIGEN_DEFAULT_L1_CACHE_SIZE=32768 EIGEN_DEFAULT_L2_CACHE_SIZE=262144
    EIGEN_DEFAULT_L3_CACHE_SIZE=2097152)
  if(HGP_PORTABLE)
    target_compile_definitions(${target} PRIVATE HGP_PORTABLE)
  endif()
  if(MSVC)  # not tested
    target_compile_options(${target} PRIVATE /fp:precise /utf-8 /W3)
  else()
    target_compile_options(${target} PRIVATE -ffp-contract=off -Wall -Wextra -Wshadow -Wconversion
      -Wno-sign-conversion $<$<BOOL:${HGP_WERROR}>:-Werror>)
  endif()
  if(EMSCRIPTEN)
    # Iterators have 32-bit differences in WebAssembly; the native builds check conversions.
    target_compile_options(${target} PRIVATE -Wno-shorten-64-to-32)
  endif()
endfunction()

# In WebAssembly, modules in which most of a run is spent are compiled for speed, all others for size. With -Os and
# -Oz Emscripten adds -fno-inline-functions, after which not even an index into a vector is inlined (decision 060).
set(HGP_HOT_MODULES "linalg|socp")
set(HGP_COLD_OPTIONS -Oz -finline-functions)

# hgp_module(NAME field SOURCES a.cpp b.cpp LINKS base mesh [PRIVATE_LINKS eigen] [HEADER_ONLY])
#
# LINKS and PRIVATE_LINKS take module names and third-party names (eigen, json, tinygltf, cli11 …, see
# HgpThirdParty.cmake). Makes hgp_<name>, alias hgp::<name>; include root is core/.
function(hgp_module)
  cmake_parse_arguments(R "HEADER_ONLY" "NAME" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  if(R_UNPARSED_ARGUMENTS OR NOT R_NAME)
    message(FATAL_ERROR "hgp_module: bad arguments: ${ARGN}")
  endif()
  hgp_named_targets(links "module ${R_NAME}" ${R_LINKS})
  hgp_named_targets(private_links "module ${R_NAME}" ${R_PRIVATE_LINKS})
  # Headers alone: programs that use the installed library do not need them.
  list(TRANSFORM private_links REPLACE "^hgp::(eigen|json|fast_float|tinygltf)$" "$<BUILD_INTERFACE:hgp::\\1>")

  set(target hgp_${R_NAME})
  if(R_HEADER_ONLY)
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
    target_compile_features(${target} INTERFACE cxx_std_20)
  else()
    add_library(${target} ${R_SOURCES})
    set(scope PUBLIC)
    hgp_compile_settings(${target})
    if(EMSCRIPTEN)  # without the names of types, of which every function object has one (decision 060)
      target_compile_options(${target} PRIVATE -fno-rtti)
    endif()
    if(EMSCRIPTEN AND NOT R_NAME MATCHES "^(${HGP_HOT_MODULES})$")
      target_compile_options(${target} PRIVATE ${HGP_COLD_OPTIONS})
    endif()
    # In the sanitizer build, only code that takes much time in tests is optimized; for other code, compiling would
    # take longer than it saves. Clang's -O1 inlines nothing by itself, and what is called may come from a unit that is
    # not optimized: the linker takes the first.
    if(R_NAME MATCHES
        "^(base|linalg|socp|optimize|improve|grid|system|field|cones|text|verify|mesh|cut|seams|parametrize)$")
      target_compile_options(${target} PRIVATE
        $<$<AND:$<CONFIG:Debug>,$<CXX_COMPILER_ID:Clang>>:-finline-functions>)
    else()
      target_compile_options(${target} PRIVATE $<$<CONFIG:Debug>:-O0>)
    endif()
    if(NOT EMSCRIPTEN)  # which it would only slow down
      set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    endif()
    target_link_libraries(${target} PRIVATE ${private_links})
  endif()
  add_library(hgp::${R_NAME} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${R_NAME})
  target_include_directories(${target} ${scope}
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/core>" "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
  target_link_libraries(${target} ${scope} ${links})
  if(HGP_INSTALL)
    install(TARGETS ${target} EXPORT hgpTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
      LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  endif()
  set_property(GLOBAL APPEND PROPERTY HGP_MODULE_TARGETS ${target})
endfunction()

# Converts names to targets; unknown names are an error.
function(hgp_named_targets out who)
  set(targets "")
  foreach(name IN LISTS ARGN)
    if(NOT TARGET hgp::${name})
      message(FATAL_ERROR "${who}: '${name}' is not here")
    endif()
    list(APPEND targets hgp::${name})
  endforeach()
  set(${out} "${targets}" PARENT_SCOPE)
endfunction()
