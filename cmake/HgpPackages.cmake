# `cpack -G DEB`: a Debian package of everything that `cmake --install` installs. Its dependencies are those of the
# libraries that the program is linked to.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME hgp)
set(CPACK_PACKAGE_CONTACT "the authors of hgp <hgp@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "seamless texture coordinates with cones and a certificate")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libeigen3-dev, libdraco-dev, libmeshoptimizer-dev")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
  "Computes texture coordinates of triangle meshes without flipped triangles, with
cones where they are placed and angles that are multiples of 360 degrees over q,
and certifies the stored numbers. Command line, and C++ library with headers.")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
