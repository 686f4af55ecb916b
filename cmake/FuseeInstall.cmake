# cmake --install, beside the program and the modules: templates, profiles, shell completions, the manual page and find_package(fusee).
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/fusee")
configure_package_config_file(cmake/fuseeConfig.cmake.in fuseeConfig.cmake INSTALL_DESTINATION "${package_dir}")
# Before 1.0 a minor version may change a contract.
write_basic_package_version_file(fuseeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(EXPORT fuseeTargets NAMESPACE fusee:: DESTINATION "${package_dir}")
install(FILES "${PROJECT_BINARY_DIR}/fuseeConfig.cmake" "${PROJECT_BINARY_DIR}/fuseeConfigVersion.cmake" cmake/Findlib3mf.cmake
        DESTINATION "${package_dir}")

install(DIRECTORY templates profiles DESTINATION "${CMAKE_INSTALL_DATADIR}/fusee")
install(FILES completions/fusee.bash DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" RENAME fusee)
install(FILES completions/fusee.zsh DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/site-functions" RENAME _fusee)
install(FILES completions/fusee.fish DESTINATION "${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d")
install(FILES docs/fusee.1 DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
