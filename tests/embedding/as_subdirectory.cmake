# demo/embed with Weft as a part of its own build, by add_subdirectory.
cmake_minimum_required(VERSION 3.23)
include(${CMAKE_CURRENT_LIST_DIR}/host.cmake)
make_temporary_folder()
# Whether it builds and runs does not depend on the optimiser and on wide vectors, which take most of the time.
run_embedding_host(-D WEFT_SOURCE_DIR=${weft_source} "-DCMAKE_CXX_FLAGS_RELEASE=-O0 -DNDEBUG"
  "-DWEFT_LEFT_OUT_TARGETS=HWY_AVX2|HWY_AVX3" -DCMAKE_UNITY_BUILD=ON)
file(REMOVE_RECURSE ${folder})
