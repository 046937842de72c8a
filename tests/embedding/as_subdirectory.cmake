# demo/embed with Weft as a part of its own build, by add_subdirectory.
cmake_minimum_required(VERSION 3.23)
include(${CMAKE_CURRENT_LIST_DIR}/host.cmake)
make_temporary_folder()
# Whether it builds and runs does not depend on the optimiser and on how many kinds of machine there are kernels for, which
# take most of the time.
set(machine "")
set(left_out "HWY_AVX2|HWY_AVX3")
file(READ /proc/cpuinfo processor)
if(processor MATCHES "avx2.*bmi2" AND processor MATCHES " aes ")
  set(machine "-march=haswell -maes")
  set(left_out "HWY_AVX3")
endif()
run_embedding_host(-D WEFT_SOURCE_DIR=${weft_source} "-DCMAKE_CXX_FLAGS_RELEASE=-O0 -DNDEBUG ${machine}"
  "-DWEFT_LEFT_OUT_TARGETS=${left_out}" -DCMAKE_UNITY_BUILD=ON)
file(REMOVE_RECURSE ${folder})
