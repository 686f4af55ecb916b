# cpack: a Debian package for each component of FuseeInstall.cmake (docs/guides/packages.md). packaging/make_packages.sh makes them
# with the same bytes from any folder.
set(FUSEE_MAINTAINER "fusee developers <fusee@fusee.invalid>" CACHE STRING "Maintainer of the Debian packages")
set(packaging "${PROJECT_SOURCE_DIR}/packaging")
set(made "${PROJECT_BINARY_DIR}/packaging")

# string(TIMESTAMP) takes SOURCE_DATE_EPOCH: the changelog has the time of the commit.
string(TIMESTAMP FUSEE_CHANGELOG_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file("${packaging}/changelog.in" "${made}/changelog" @ONLY)
# gzip without name and time: the same bytes from every build.
function(fusee_gzip file to)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
  get_filename_component(folder "${to}" DIRECTORY)
  file(MAKE_DIRECTORY "${folder}")
  execute_process(COMMAND gzip -9nc "${file}" OUTPUT_FILE "${to}" COMMAND_ERROR_IS_FATAL ANY)
endfunction()
fusee_gzip("${made}/changelog" "${made}/changelog.gz")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME fusee)
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")  # of the sources; packaging/copyright is that of the packages
set(CPACK_PACKAGE_CONTACT "${FUSEE_MAINTAINER}")
set(CPACK_PACKAGING_INSTALL_PREFIX "/usr")
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}/packages")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE gzip)  # quick: make_packages.sh packs again, with xz
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_COMPONENTS_ALL "")

# fusee_package(program fusee "science" "first line" "text"): what all have in common.
macro(fusee_package component package section summary text)
  install(FILES "${packaging}/copyright" "${made}/changelog.gz" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}" COMPONENT ${component})
  string(TOUPPER ${component} upper)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${summary}\n${text}")
endmacro()

fusee_package(program fusee science "cams for antagonistic variable-stiffness joints"
  "Turns the spring law of a joint into cams that a shop can print or machine,\nchecks them, and compares the built joint with its model.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "openscad, prusa-slicer, linuxcnc-uspace, admesh, python3-fusee, fusee-mujoco")

# The static libraries need what FuseeDependencies.cmake finds: the libraries of packages.txt.
file(STRINGS "${PROJECT_SOURCE_DIR}/packages.txt" lines)
set(libraries "")
set(heading "")
foreach(line IN LISTS lines)
  if(line MATCHES "^# ([a-z_]+):")
    set(heading "${CMAKE_MATCH_1}")
  elseif(heading MATCHES "^(libraries|make|diagnose|whole)$")
    list(APPEND libraries "${line}")
  endif()
endforeach()
list(JOIN libraries ", " libraries)
fusee_package(dev libfusee-dev libdevel "modules of fusee as static libraries"
  "Headers, static libraries and find_package(fusee) of the modules behind the\nprogram fusee: spring laws, cams, solids, diagnosis.")
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "fusee (= ${PROJECT_VERSION}), ${libraries}, pkg-config")  # fusee: the libraries that are loaded

if(TARGET fusee_mujoco)
  fusee_package(mujoco fusee-mujoco science "models of MuJoCo for fusee diagnose"
    "The companion of fusee that describes an MJCF file and answers for it in a\ndiagnosis; a program of its own on libmujoco.")
  set(CPACK_DEBIAN_MUJOCO_PACKAGE_SHLIBDEPS ON)
endif()

if(TARGET fusee_python)
  fusee_package(python python3-fusee python "Python module of fusee"
    "Design, simulation, making and diagnosis of variable-stiffness joints on\nNumPy arrays, with types and docstrings.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.11), python3 (<< 3.12), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-matplotlib")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${packaging}/python/postinst;${packaging}/python/prerm")
endif()
include(CPack)
