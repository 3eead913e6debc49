# The target `hgp::hgp`, which includes everything that a program needs; `hgp::core`, which has neither files nor JSON and
# links nothing but Eigen; and `cmake --install`: libraries, public
# headers and the files for find_package(hgp) and pkg-config.

add_library(hgp_hgp INTERFACE)
add_library(hgp::hgp ALIAS hgp_hgp)
set_target_properties(hgp_hgp PROPERTIES EXPORT_NAME hgp)
target_link_libraries(hgp_hgp INTERFACE hgp::api hgp::parametrize hgp::verify hgp::eigen)
add_library(hgp_core INTERFACE)
add_library(hgp::core ALIAS hgp_core)
set_target_properties(hgp_core PROPERTIES EXPORT_NAME core)
target_link_libraries(hgp_core INTERFACE hgp::parametrize hgp::cones hgp::quads hgp::verify)
if(EMSCRIPTEN OR NOT HGP_INSTALL)
  return()
endif()

# The headers that programs include, and those that these include; no others are public.
function(hgp_public_headers out)
  set(todo hgp/eigen.h hgp/api/session.h hgp/api/file_maps.h hgp/api/notes.h
    hgp/api/options_from_json.h hgp/api/option_table.h hgp/api/option_words.h hgp/parametrize/parametrize.h hgp/mesh/tri_mesh.h
    hgp/verify/certificate.h hgp/base/threads.h)
  set(found "")
  while(todo)
    list(POP_FRONT todo header)
    if(header IN_LIST found)
      continue()
    endif()
    list(APPEND found "${header}")
    file(STRINGS "${PROJECT_SOURCE_DIR}/core/${header}" lines REGEX "^#include \"hgp/")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^#include \"(hgp/[^\"]+)\".*" "\\1" next "${line}")
      list(APPEND todo "${next}")
    endforeach()
  endwhile()
  set(${out} "${found}" PARENT_SCOPE)
endfunction()

include(CMakePackageConfigHelpers)
set(HGP_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/hgp)
install(TARGETS hgp_hgp hgp_core EXPORT hgpTargets)
hgp_public_headers(headers)
foreach(header IN LISTS headers)
  get_filename_component(folder "${header}" DIRECTORY)
  install(FILES "core/${header}" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/${folder}")
endforeach()
# Static archives leave the decoders of compressed glTF to the program.
set(HGP_ARCHIVE_NEEDS "")
if(NOT BUILD_SHARED_LIBS)
  foreach(library draco meshoptimizer)
    if(TARGET hgp::${library} AND HGP_${library}_LIBRARY)
      list(APPEND HGP_ARCHIVE_NEEDS ${library})
    endif()
  endforeach()
endif()
install(EXPORT hgpTargets NAMESPACE hgp:: DESTINATION ${HGP_PACKAGE_DIR})
configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/hgpConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/hgpConfig.cmake" INSTALL_DESTINATION ${HGP_PACKAGE_DIR})
write_basic_package_version_file("${PROJECT_BINARY_DIR}/hgpConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/hgpConfig.cmake" "${PROJECT_BINARY_DIR}/hgpConfigVersion.cmake"
  cmake/HgpThirdParty.cmake DESTINATION ${HGP_PACKAGE_DIR})
install(FILES LICENSE THIRD_PARTY_NOTICES.md THIRD_PARTY_LICENSES.txt README.md CHANGELOG.md
  DESTINATION ${CMAKE_INSTALL_DOCDIR})

# pkg-config: the libraries of the modules, dependents first.
get_property(targets GLOBAL PROPERTY HGP_MODULE_TARGETS)
list(REVERSE targets)
list(JOIN targets " -l" HGP_PC_LIBS)
set(HGP_PC_PRIVATE "")
foreach(library IN LISTS HGP_ARCHIVE_NEEDS)
  string(APPEND HGP_PC_PRIVATE " -l${library}")
endforeach()
if(CMAKE_THREAD_LIBS_INIT)
  string(APPEND HGP_PC_PRIVATE " ${CMAKE_THREAD_LIBS_INIT}")
endif()
file(RELATIVE_PATH HGP_PC_UP "/prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/prefix")
string(REGEX REPLACE "/$" "" HGP_PC_UP "${HGP_PC_UP}")
configure_file(cmake/hgp.pc.in "${PROJECT_BINARY_DIR}/hgp.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/hgp.pc" DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# `cmake --install` of a build that is not complete: says what to build before it copies anything (the rule that includes
# this file comes first, in the main CMakeLists.txt).
set(files "")
foreach(target IN LISTS targets)
  get_target_property(kind ${target} TYPE)
  if(NOT kind STREQUAL "INTERFACE_LIBRARY")
    string(APPEND files "\"$<TARGET_FILE:${target}>\"\n")
  endif()
endforeach()
add_custom_target(hgp_installed DEPENDS ${targets})
if(TARGET hgp_pages)
  string(APPEND files "\"$<TARGET_FILE:hgp>\"\n\"${PROJECT_BINARY_DIR}/examples/cli/hgp.1\"\n")
  add_dependencies(hgp_installed hgp_pages)
endif()
file(GENERATE OUTPUT "${PROJECT_BINARY_DIR}/hgp_is_built-$<CONFIG>.cmake" CONTENT
"set(missing \"\")
foreach(file IN ITEMS
${files})
  if(NOT EXISTS \"\${file}\")
    get_filename_component(name \"\${file}\" NAME)
    string(APPEND missing \" \${name}\")
  endif()
endforeach()
if(missing)
  message(FATAL_ERROR \"hgp is not built completely, nothing is installed; missing:\${missing}\\nBuild it first: \"
    \"cmake --build ${PROJECT_BINARY_DIR} --target hgp_installed\")
endif()
")
