# cmake --install, beside the program and the modules: templates, profiles, shell completions, the manual page and find_package(fusee).
# Components: program, dev (headers, static libraries, CMake's package), python, and mujoco where its library is. FuseePackages.cmake makes a Debian package of each.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/fusee")
configure_package_config_file(cmake/fuseeConfig.cmake.in fuseeConfig.cmake INSTALL_DESTINATION "${package_dir}")
# Before 1.0 a minor version may change a contract.
write_basic_package_version_file(fuseeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(EXPORT fuseeTargets NAMESPACE fusee:: DESTINATION "${package_dir}" COMPONENT dev)
install(FILES "${PROJECT_BINARY_DIR}/fuseeConfig.cmake" "${PROJECT_BINARY_DIR}/fuseeConfigVersion.cmake" cmake/Findlib3mf.cmake
        DESTINATION "${package_dir}" COMPONENT dev)

set(zsh_folder zsh/site-functions)
if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  set(zsh_folder zsh/vendor-completions)  # Debian's policy: site-functions is for the local administrator
endif()
install(DIRECTORY templates profiles DESTINATION "${CMAKE_INSTALL_DATADIR}/fusee" COMPONENT program)
install(FILES completions/fusee.bash DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" RENAME fusee COMPONENT program)
install(FILES completions/fusee.zsh DESTINATION "${CMAKE_INSTALL_DATADIR}/${zsh_folder}" RENAME _fusee COMPONENT program)
install(FILES completions/fusee.fish DESTINATION "${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d" COMPONENT program)
if(TARGET fusee_app)  # the program prints its manual page; gzip without name and time: the same bytes from every build
  install(CODE "execute_process(COMMAND \"$<TARGET_FILE:fusee_app>\" man COMMAND gzip -9nc OUTPUT_FILE \"${PROJECT_BINARY_DIR}/fusee.1.gz\" COMMAND_ERROR_IS_FATAL ANY)"
          COMPONENT program)
  install(FILES "${PROJECT_BINARY_DIR}/fusee.1.gz" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT program)
endif()
install(FILES README.md CHANGELOG.md CONTRIBUTING.md SECURITY.md DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT program)
install(DIRECTORY docs DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT program)
