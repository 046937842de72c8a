# Not run here; see README.md beside this folder.
vcpkg_from_git(OUT_SOURCE_PATH source URL https://example.invalid/weft.git REF v${VERSION})
vcpkg_check_features(OUT_FEATURE_OPTIONS features FEATURES tbb WEFT_TBB)
vcpkg_cmake_configure(SOURCE_PATH ${source} OPTIONS
  -DWEFT_BUILD_RENDER=OFF -DWEFT_BUILD_DEMO=OFF -DWEFT_BUILD_TESTS=OFF ${features})
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/weft)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE ${CURRENT_PACKAGES_DIR}/debug/include ${CURRENT_PACKAGES_DIR}/debug/share)
vcpkg_install_copyright(FILE_LIST ${source}/LICENSE)
