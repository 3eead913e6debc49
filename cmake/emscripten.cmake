# Finds the toolchain file of the emcc on the PATH (tested: Debian's 3.1.6).
find_program(HGP_EMCC emcc REQUIRED)
file(REAL_PATH "${HGP_EMCC}" HGP_EMCC_REAL)
cmake_path(GET HGP_EMCC_REAL PARENT_PATH HGP_EMSCRIPTEN_ROOT)
set(HGP_EMSCRIPTEN_TOOLCHAIN
  "${HGP_EMSCRIPTEN_ROOT}/cmake/Modules/Platform/Emscripten.cmake")
if(NOT EXISTS "${HGP_EMSCRIPTEN_TOOLCHAIN}")
  set(HGP_EMSCRIPTEN_TOOLCHAIN
    "/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake")
endif()
# Node ≥ 18 has `fetch`, which Emscripten 3.1.6 prefers over the file system.
set(CMAKE_CROSSCOMPILING_EMULATOR "node;--no-experimental-fetch" CACHE STRING "")
include("${HGP_EMSCRIPTEN_TOOLCHAIN}")
set(CMAKE_CROSSCOMPILING_EMULATOR "node;--no-experimental-fetch")
