# Imported target lib3mf. Its own pkg-config file asks for a library that Debian does not ship, so it is found by hand.
find_library(LIB3MF_LIBRARY 3MF)
find_path(LIB3MF_INCLUDE_DIR NAMES Model/COM/NMR_DLLInterfaces.h PATH_SUFFIXES lib3mf)
mark_as_advanced(LIB3MF_LIBRARY LIB3MF_INCLUDE_DIR)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(lib3mf REQUIRED_VARS LIB3MF_LIBRARY LIB3MF_INCLUDE_DIR)

if(lib3mf_FOUND AND NOT TARGET lib3mf)
  add_library(lib3mf INTERFACE IMPORTED)
  target_link_libraries(lib3mf INTERFACE "${LIB3MF_LIBRARY}")
  target_include_directories(lib3mf SYSTEM INTERFACE "${LIB3MF_INCLUDE_DIR}")
endif()
