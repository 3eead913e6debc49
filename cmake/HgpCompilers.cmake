# Compilers that are known to work; others are accepted with a warning.
# Tested: GCC 11 and 12, Clang 14, Emscripten 3.1.6; MinGW-w64 12 under Wine, by packaging/windows. Not tested: MSVC,
# Apple Clang.

foreach(known "GNU|11" "Clang|14")
  string(REPLACE "|" ";" known "${known}")
  list(GET known 0 id)
  list(GET known 1 version)
  if(CMAKE_CXX_COMPILER_ID STREQUAL id AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS version)
    message(WARNING "hgp: ${id} ${CMAKE_CXX_COMPILER_VERSION} is older than ${version}, the oldest that is tested")
  endif()
endforeach()

# For features that these compilers lack there are alternatives in ISO C++, which our tests build with GCC and Clang.
if(CMAKE_CXX_COMPILER_ID MATCHES "^(MSVC|AppleClang)$")
  message(WARNING "hgp: ${CMAKE_CXX_COMPILER_ID} on ${CMAKE_SYSTEM_NAME} is not tested; tested are GCC 11 and 12 and "
    "Clang 14 on Linux")
endif()
if(MSVC OR MINGW)
  set(HGP_PORTABLE ON)
endif()
