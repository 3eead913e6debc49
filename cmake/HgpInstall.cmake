# `cmake --install`: libraries, headers and what find_package(hgp) needs.

include(CMakePackageConfigHelpers)
get_property(HGP_INSTALLED GLOBAL PROPERTY HGP_MODULE_TARGETS)
if(HGP_INSTALLED AND NOT EMSCRIPTEN)
  set(HGP_PACKAGE_DIR lib/cmake/hgp)
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/core/hgp" DESTINATION include
    FILES_MATCHING PATTERN "*.h")
  install(EXPORT hgpTargets NAMESPACE hgp:: DESTINATION ${HGP_PACKAGE_DIR})
  configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/hgpConfig.cmake.in"
    "${PROJECT_BINARY_DIR}/hgpConfig.cmake" INSTALL_DESTINATION ${HGP_PACKAGE_DIR})
  write_basic_package_version_file("${PROJECT_BINARY_DIR}/hgpConfigVersion.cmake"
    COMPATIBILITY SameMinorVersion)
  install(FILES "${PROJECT_BINARY_DIR}/hgpConfig.cmake"
    "${PROJECT_BINARY_DIR}/hgpConfigVersion.cmake"
    "${PROJECT_SOURCE_DIR}/cmake/HgpThirdParty.cmake" DESTINATION ${HGP_PACKAGE_DIR})
endif()
