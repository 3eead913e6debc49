# Third-party code under names of our own (hgp::eigen, hgp::json …), as SYSTEM includes.
#
# Searched in this order: an existing target of the enclosing project, the package's own CMake files, the path of
# its header. Under Emscripten only the path is used, because its toolchain searches only its own sysroot. This file is
# installed with the library, so that the exported modules find the same names: there HGP_THIRD_PARTY lists what the
# installed archives need, and nothing else is searched.

# Makes a copy of a header with `text` replaced by `by`; it is written only if it differs from the existing copy.
function(hgp_edited_header header copy text by)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${header}")
  file(READ "${header}" original)
  string(REPLACE "${text}" "${by}" edited "${original}")
  if(edited STREQUAL original)
    message(FATAL_ERROR "third party: ${header} does not say '${text}'")
  endif()
  if(IS_SYMLINK "${copy}")
    file(REMOVE "${copy}")
  elseif(EXISTS "${copy}")
    file(READ "${copy}" there)
    if(there STREQUAL edited)
      return()
    endif()
  endif()
  file(WRITE "${copy}" "${edited}")
endfunction()

# Under Emscripten and MinGW /usr/include must never be on the include path (glibc's headers would shadow
# those of the target), so single headers are linked into a folder of the build tree.
#
# hgp_third_party_header(eigen Eigen/Core [PACKAGE Eigen3] [TARGET Eigen3::Eigen] [SUFFIX eigen3]
#   [EMSCRIPTEN_REPLACE text by])   a copy of the header with other text, instead of the link
function(hgp_third_party_header name header)
  cmake_parse_arguments(T "" "PACKAGE;TARGET;SUFFIX" "EMSCRIPTEN_REPLACE" ${ARGN})
  if(TARGET hgp::${name} OR (DEFINED HGP_THIRD_PARTY AND NOT name IN_LIST HGP_THIRD_PARTY))
    return()
  endif()
  if(T_PACKAGE AND NOT EMSCRIPTEN)
    if(NOT TARGET ${T_TARGET})
      find_package(${T_PACKAGE} QUIET CONFIG)
    endif()
    if(TARGET ${T_TARGET})
      add_library(hgp::${name} INTERFACE IMPORTED GLOBAL)
      set_target_properties(hgp::${name} PROPERTIES INTERFACE_LINK_LIBRARIES ${T_TARGET})
      return()
    endif()
  endif()
  find_path(HGP_${name}_DIR NAMES ${header} PATHS /usr/include /usr/local/include
    PATH_SUFFIXES ${T_SUFFIX} NO_CMAKE_FIND_ROOT_PATH)
  if(NOT HGP_${name}_DIR)
    message(STATUS "third party: ${name} not found (${header})")
    return()
  endif()
  set(dir "${HGP_${name}_DIR}")
  if((EMSCRIPTEN OR (MINGW AND CMAKE_CROSSCOMPILING)) AND NOT dir MATCHES "eigen3")
    string(REGEX REPLACE "/.*" "" top "${header}")
    set(links "${CMAKE_BINARY_DIR}/third_party")
    file(MAKE_DIRECTORY "${links}")
    if(T_EMSCRIPTEN_REPLACE AND EMSCRIPTEN)
      hgp_edited_header("${dir}/${header}" "${links}/${header}" ${T_EMSCRIPTEN_REPLACE})
    else()
      file(CREATE_LINK "${dir}/${top}" "${links}/${top}" SYMBOLIC)
    endif()
    set(dir "${links}")
  endif()
  add_library(hgp::${name} INTERFACE IMPORTED GLOBAL)
  if(NOT dir STREQUAL "/usr/include")
    set_target_properties(hgp::${name} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${dir}")
  endif()
endfunction()

# Finds a compiled library of the system; native builds only.
function(hgp_third_party_library name header library)
  if(EMSCRIPTEN OR TARGET hgp::${name} OR (DEFINED HGP_THIRD_PARTY AND NOT name IN_LIST HGP_THIRD_PARTY))
    return()
  endif()
  find_library(HGP_${name}_LIBRARY NAMES ${library})
  if(MINGW AND CMAKE_CROSSCOMPILING)  # the headers of this machine say nothing about the target's libraries
    if(HGP_${name}_LIBRARY)
      add_library(hgp::${name} INTERFACE IMPORTED GLOBAL)
      set_target_properties(hgp::${name} PROPERTIES INTERFACE_LINK_LIBRARIES "${HGP_${name}_LIBRARY}")
    endif()
    return()
  endif()
  if(NOT DEFINED HGP_THIRD_PARTY)
    hgp_third_party_header(${name} ${header})
  elseif(HGP_${name}_LIBRARY)  # no installed header includes one of it
    add_library(hgp::${name} INTERFACE IMPORTED GLOBAL)
  endif()
  if(TARGET hgp::${name} AND HGP_${name}_LIBRARY)
    set_target_properties(hgp::${name} PROPERTIES
      INTERFACE_LINK_LIBRARIES "${HGP_${name}_LIBRARY}")
  endif()
endfunction()

hgp_third_party_header(eigen Eigen/Core PACKAGE Eigen3 TARGET Eigen3::Eigen SUFFIX eigen3)
hgp_third_party_header(json nlohmann/json.hpp
  PACKAGE nlohmann_json TARGET nlohmann_json::nlohmann_json)
hgp_third_party_header(fast_float fast_float/fast_float.h
  PACKAGE FastFloat TARGET FastFloat::fast_float)
# Its messages would link all streams and locales into the module (docs/decisions/057).
hgp_third_party_header(tinygltf tiny_gltf.h
  EMSCRIPTEN_REPLACE "std::stringstream" "hgp::io::TextStream")
hgp_third_party_header(cli11 CLI/CLI.hpp PACKAGE CLI11 TARGET CLI11::CLI11)
hgp_third_party_library(draco draco/compression/decode.h draco)
hgp_third_party_library(meshoptimizer meshoptimizer.h meshoptimizer)
hgp_third_party_library(cholmod suitesparse/cholmod.h cholmod)
hgp_third_party_library(metis metis.h metis)

# The required libraries that are missing, with the names of their packages; empty if there are none.
function(hgp_missing_third_party out)
  set(missing "")
  set(needed eigen json fast_float tinygltf)
  if(DEFINED HGP_THIRD_PARTY)
    set(needed ${HGP_THIRD_PARTY})
  endif()
  foreach(one "eigen|Eigen 3.4|libeigen3-dev|eigen|eigen3"
              "json|nlohmann/json 3.11|nlohmann-json3-dev|nlohmann-json|nlohmann-json"
              "fast_float|fast_float 3.9|libfast-float-dev|fast_float|fast-float"
              "tinygltf|tinygltf 2.7|libtinygltf-dev|-|tinygltf"
              "draco|Draco 1.5|libdraco-dev|draco|draco"
              "meshoptimizer|meshoptimizer 0.18|libmeshoptimizer-dev|meshoptimizer|meshoptimizer")
    string(REPLACE "|" ";" one "${one}")
    list(GET one 0 name)
    if(name IN_LIST needed AND NOT TARGET hgp::${name})
      list(GET one 1 title)
      list(GET one 2 debian)
      list(GET one 3 brew)
      list(GET one 4 vcpkg)
      string(APPEND missing "\n  ${title}: Debian ${debian}, Homebrew ${brew}, vcpkg ${vcpkg}")
    endif()
  endforeach()
  set(${out} "${missing}" PARENT_SCOPE)
endfunction()
