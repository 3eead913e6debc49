# Third-party code under names of our own (hgp::eigen, hgp::json …), as SYSTEM includes.
#
# Found by path and never through the packages' own CMake files: those are invisible under the
# Emscripten toolchain, whose find root is its own sysroot. Installed with the library, so that the
# exported modules find the same names again.

# Under Emscripten /usr/include must never be on the include path (glibc's headers would shadow
# musl's), so single headers are linked into a folder of the build tree.
function(hgp_third_party_header name header)
  if(TARGET hgp::${name})
    return()
  endif()
  find_path(HGP_${name}_DIR NAMES ${header} PATHS /usr/include /usr/local/include ${ARGN}
    NO_CMAKE_FIND_ROOT_PATH)
  if(NOT HGP_${name}_DIR)
    message(STATUS "third party: ${name} not found (${header})")
    return()
  endif()
  set(dir "${HGP_${name}_DIR}")
  if(EMSCRIPTEN AND NOT dir MATCHES "eigen3")
    string(REGEX REPLACE "/.*" "" top "${header}")
    set(links "${CMAKE_BINARY_DIR}/third_party")
    file(MAKE_DIRECTORY "${links}")
    file(CREATE_LINK "${dir}/${top}" "${links}/${top}" SYMBOLIC)
    set(dir "${links}")
  endif()
  add_library(hgp::${name} INTERFACE IMPORTED GLOBAL)
  if(NOT dir STREQUAL "/usr/include")
    set_target_properties(hgp::${name} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${dir}")
  endif()
endfunction()

# A compiled library of the system; native builds only.
function(hgp_third_party_library name header library)
  if(EMSCRIPTEN OR TARGET hgp::${name})
    return()
  endif()
  find_library(HGP_${name}_LIBRARY NAMES ${library})
  hgp_third_party_header(${name} ${header} ${ARGN})
  if(TARGET hgp::${name} AND HGP_${name}_LIBRARY)
    set_target_properties(hgp::${name} PROPERTIES
      INTERFACE_LINK_LIBRARIES "${HGP_${name}_LIBRARY}")
  endif()
endfunction()

hgp_third_party_header(eigen Eigen/Core /usr/include/eigen3 /usr/local/include/eigen3)
hgp_third_party_header(json nlohmann/json.hpp)
hgp_third_party_header(tinygltf tiny_gltf.h)
hgp_third_party_header(cli11 CLI/CLI.hpp)
hgp_third_party_library(draco draco/compression/decode.h draco)
hgp_third_party_library(meshoptimizer meshoptimizer.h meshoptimizer)
hgp_third_party_library(cholmod suitesparse/cholmod.h cholmod)
hgp_third_party_library(metis metis.h metis)
