# Weft as one shared library, which hosts in C and Python load.
cmake_minimum_required(VERSION 3.23)
include(${CMAKE_CURRENT_LIST_DIR}/host.cmake)
make_temporary_folder()
set(library ${weft_build}/tests/embedding/libweft_as_shared.so)

# It shows its interface and nothing else.
list_symbols(${library})
list(LENGTH symbols count)
set(shown ${symbols})
list(FILTER shown EXCLUDE REGEX "^weft_[a-z_]+ ")
list(FILTER shown EXCLUDE REGEX "^weft::(World|CookedCloth|DrawnMesh|FixedStep)::[A-Za-z_~=]+(abi:cxx11)?\\(")
list(FILTER shown EXCLUDE REGEX "^weft::(Fabric::named|make_sheet|make_proxy|carry_state|numbers_of|SettingNumber::has|load_obj|save_obj|cut_mesh|edges_along|edges_to_tear|fabrics|replay|set_hooks|memory_in_use|detail::fail_(value|error))\\(")
if(shown OR count LESS 150)
  fail("of the ${count} symbols of the shared library these are none of its interface: ${shown}")
endif()
message(STATUS "${count} symbols")

# All calls for C, by this library.
set(tests ${CMAKE_CURRENT_LIST_DIR}/c)
run(${c_compiler} -std=c99 -DWEFT_SHARED -I ${weft_source}/cloth/include -I ${weft_source}/engine/include
  ${tests}/main.c ${tests}/cut.c ${tests}/host.c ${tests}/look.c -o ${folder}/c_host ${library} -lm)
get_filename_component(library_folder ${library} DIRECTORY)
run(${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${library_folder} ${folder}/c_host ${folder})

# weft::gltf is a static library beside the shared one: its install is set up there, and it needs the interface alone.
if(EXISTS ${weft_build}/demo/gltf/libweft_gltf.a)
  run(${CMAKE_COMMAND} -S ${weft_source} -B ${folder}/with_gltf -G ${generator} -D CMAKE_BUILD_TYPE=${build_type}
    -D CMAKE_CXX_COMPILER=${cxx_compiler} -D BUILD_SHARED_LIBS=ON -D WEFT_BUILD_GLTF=ON -D WEFT_BUILD_RENDER=OFF
    -D WEFT_BUILD_DEMO=OFF -D WEFT_BUILD_TESTS=OFF)
  file(READ ${folder}/with_gltf/cmake_install.cmake installed)
  foreach(wanted libweft_gltf.a weftGltfTargets.cmake demo/gltf/include)
    if(NOT installed MATCHES "${wanted}")
      fail("a shared Weft with weft::gltf does not install ${wanted}")
    endif()
  endforeach()
  file(WRITE ${folder}/gltf.cpp "#include <weft/gltf.h>
#include <cstdio>
int main() {
    const auto asset = weft::GltfAsset::load(\"none.glb\");
    if (!asset) std::puts(asset.error().message.c_str());
    return asset.ok() ? 1 : 0;
}
")
  run(${cxx_compiler} -std=c++20 -DWEFT_SHARED -I ${weft_source}/demo/gltf/include -I ${weft_source}/cloth/include
    -I ${weft_source}/engine/include ${folder}/gltf.cpp -o ${folder}/gltf_host ${weft_build}/demo/gltf/libweft_gltf.a ${draco}
    ${library})
  run(${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${library_folder} ${folder}/gltf_host)
  if(NOT output MATCHES "none.glb: cannot be read")
    fail("a host with weft::gltf and a shared Weft ran, but was told nothing:\n${output}")
  endif()
endif()

find_program(python python3)
if(python)
  run(${python} ${weft_source}/demo/embed/python/flag.py ${library} ${folder}/energy.svg)
  if(NOT output MATCHES "300 steps; at the end the flag moves with [0-9.]+ J and hangs 0\\.[0-9]*[1-9]")
    fail("flag.py ran, but its flag does not wave:\n${output}")
  endif()
  file(READ ${folder}/energy.svg picture)
  if(NOT picture MATCHES "polyline.*polyline")
    fail("flag.py drew no curves:\n${picture}")
  endif()
  message(STATUS "${output}")
endif()
file(REMOVE_RECURSE ${folder})
