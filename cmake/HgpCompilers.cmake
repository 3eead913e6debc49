# Compilers that are known to work; others are tried, with a word of warning.
# Tested: GCC 11 and 12, Clang 14, Emscripten 3.1.6. Not tested: Apple Clang, MinGW. MSVC lacks the vector
# extensions and flags that the dense kernels use.

if(CMAKE_CXX_COMPILER_ID STREQUAL "MSVC")
  message(FATAL_ERROR "hgp: MSVC is not supported; build with GCC 11, Clang 14 or newer (clang-cl is untested)")
endif()
foreach(known "GNU|11" "Clang|14")
  string(REPLACE "|" ";" known "${known}")
  list(GET known 0 id)
  list(GET known 1 version)
  if(CMAKE_CXX_COMPILER_ID STREQUAL id AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS version)
    message(WARNING "hgp: ${id} ${CMAKE_CXX_COMPILER_VERSION} is older than ${version}, the oldest that is tested")
  endif()
endforeach()
