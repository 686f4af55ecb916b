# fusee_module(cam SOURCES a.cpp ... USES core math ... LINKS Eigen3::Eigen ... PRIVATE_LINKS ...)
# One room: static library fusee_<room> with alias fusee::<room>; its headers are include/fusee/<room>/*.h and each must
# compile alone; it may include only the rooms it USES (checked at configure time), and only rooms declared before it.
include(GNUInstallDirs)

function(fusee_module room)
  cmake_parse_arguments(M "" "" "SOURCES;USES;LINKS;PRIVATE_LINKS" ${ARGN})
  file(GLOB headers CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/include/fusee/${room}/*.h")
  add_library(fusee_${room} STATIC ${M_SOURCES})
  add_library(fusee::${room} ALIAS fusee_${room})
  set_target_properties(fusee_${room} PROPERTIES EXPORT_NAME ${room} VERIFY_INTERFACE_HEADER_SETS ON)
  target_sources(fusee_${room} PUBLIC FILE_SET HEADERS BASE_DIRS "${PROJECT_SOURCE_DIR}/include" FILES ${headers})
  foreach(used IN LISTS M_USES)
    if(NOT TARGET fusee_${used})
      message(FATAL_ERROR "room '${room}' uses '${used}', which is not on a floor below it")
    endif()
    target_link_libraries(fusee_${room} PUBLIC fusee::${used})
  endforeach()
  target_link_libraries(fusee_${room} PUBLIC fusee_options ${M_LINKS} PRIVATE ${M_PRIVATE_LINKS})
  fusee_check_layering(${room} "${M_USES}")
  install(TARGETS fusee_${room} EXPORT fuseeTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
          FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endfunction()

# Every `#include "fusee/X/..."` of a room must name the room itself or one that it declares in USES, and no include may climb
# out of its folder, which would go round that rule. Linking is transitive, including is not.
function(fusee_check_layering room uses)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/include/fusee/${room}/*.h"
       "${PROJECT_SOURCE_DIR}/src/${room}/*.cpp" "${PROJECT_SOURCE_DIR}/src/${room}/*.h")
  set(allowed ${room} ${uses})
  foreach(file IN LISTS files)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
    file(STRINGS "${file}" lines REGEX "^[ \t]*#[ \t]*include[ \t]*([\"<]fusee/|\"[^\"]*\\.\\./)")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^[^\"<]*[\"<]fusee/([a-z_]+)/.*" "\\1" other "${line}")
      if(line MATCHES "\\.\\./" OR NOT other IN_LIST allowed)
        string(STRIP "${line}" line)
        message(FATAL_ERROR "${file}: room '${room}' (USES ${uses}) may not have: ${line}")
      endif()
    endforeach()
  endforeach()
endfunction()
