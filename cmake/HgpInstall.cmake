# The target `hgp::hgp`, which includes everything that a program needs; and `cmake --install`: libraries, public
# headers and the files for find_package(hgp) and pkg-config.

add_library(hgp_hgp INTERFACE)
add_library(hgp::hgp ALIAS hgp_hgp)
set_target_properties(hgp_hgp PROPERTIES EXPORT_NAME hgp)
target_link_libraries(hgp_hgp INTERFACE hgp::api hgp::parametrize hgp::verify hgp::eigen)
if(EMSCRIPTEN OR NOT HGP_INSTALL)
  return()
endif()

# The headers that programs include, and those that these include; no others are public.
function(hgp_public_headers out)
  set(todo hgp/eigen.h hgp/api/session.h hgp/parametrize/parametrize.h hgp/mesh/tri_mesh.h
    hgp/verify/certificate.h)
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
install(TARGETS hgp_hgp EXPORT hgpTargets)
hgp_public_headers(headers)
foreach(header IN LISTS headers)
  get_filename_component(folder "${header}" DIRECTORY)
  install(FILES "core/${header}" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/${folder}")
endforeach()
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
set(HGP_PC_DECODERS "")
foreach(library draco meshoptimizer)
  if(HGP_${library}_LIBRARY)
    string(APPEND HGP_PC_DECODERS " ${HGP_${library}_LIBRARY}")
  endif()
endforeach()
configure_file(cmake/hgp.pc.in "${PROJECT_BINARY_DIR}/hgp.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/hgp.pc" DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
