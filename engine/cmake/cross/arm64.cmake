# For 64-bit ARM, by Debian's cross compiler; tests run under qemu-user.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)

set(sysroot ${CMAKE_CURRENT_LIST_DIR}/../../../build/sysroot-arm64)
cmake_path(NORMAL_PATH sysroot)
if(NOT EXISTS ${sysroot}/is_whole)
  execute_process(COMMAND ${CMAKE_CURRENT_LIST_DIR}/sysroot arm64 ${sysroot} COMMAND_ERROR_IS_FATAL ANY)
endif()
# Header-only libraries come from the system's own packages.
set(CMAKE_FIND_ROOT_PATH ${sysroot}/usr ${sysroot})
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64 -L /usr/aarch64-linux-gnu -E LD_LIBRARY_PATH=${sysroot}/usr/lib/aarch64-linux-gnu)
