# fusee_module(cam SOURCES a.cpp ... USES core math ... LINKS Eigen3::Eigen ... PRIVATE_LINKS ... [UNITY 12] [OPTIMIZE 1])
# One module: static library fusee_<module> with alias fusee::<module>; its headers are include/fusee/<module>/**.h and each must
# compile alone; it may include only the modules it USES (checked at configure time), and only modules declared before it.
# UNITY n: compile the sources n at a time (0: all at once), so that their common headers are read once. Names in the anonymous namespaces
# of a module must differ (tests/house/unity_names_test.py). -DFUSEE_UNITY=OFF compiles each source alone.
# OPTIMIZE 1: -O1 instead of -O2 in a Release build, for a module that computes little. Floating-point results are the same.
# fusee_module(report PART page HEADERS findings.h ...): a library of its own, fusee_report_page, of some sources and headers of a module, so
# that a program builds no more of the module than it links. Others name it in USES as report_page. fusee_parts(report page ...) makes
# fusee::report of all of them, and must follow the last part.
# With FUSEE_PARTIAL a module or part that uses one that is left out is left out too, with the rest of its CMakeLists.txt.
include(GNUInstallDirs)

macro(fusee_module)
  fusee_find_missing(missing ${ARGN})
  if(NOT missing)
    fusee_add_module(${ARGN})
  elseif(NOT "${ARGN}" MATCHES ";PART;")
    return()
  endif()
endmacro()

# The modules in USES that are left out.
function(fusee_find_missing variable module)
  cmake_parse_arguments(M "" "" "SOURCES;USES;LINKS;PRIVATE_LINKS;HEADERS" ${ARGN})
  set(missing "")
  foreach(used IN LISTS M_USES)
    if(FUSEE_PARTIAL AND NOT TARGET fusee_${used})
      list(APPEND missing ${used})
    endif()
  endforeach()
  if(missing)
    message(STATUS "Left out for want of ${missing}: ${module}")
  endif()
  set(${variable} "${missing}" PARENT_SCOPE)
endfunction()

function(fusee_add_module module)
  cmake_parse_arguments(M "" "UNITY;OPTIMIZE;PART" "SOURCES;USES;LINKS;PRIVATE_LINKS;HEADERS" ${ARGN})
  set(folder "${PROJECT_SOURCE_DIR}/include/fusee/${module}")
  if(M_PART)
    list(TRANSFORM M_HEADERS PREPEND "${folder}/" OUTPUT_VARIABLE headers)
    list(TRANSFORM M_SOURCES PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/" REGEX "^[^/]" OUTPUT_VARIABLE files)
    list(APPEND files ${headers})
    fusee_check_layering(${module} "${M_USES}" "${files}")
    set_property(GLOBAL APPEND PROPERTY fusee_uses_of_${module} ${M_USES})
    set_property(GLOBAL PROPERTY fusee_module_of_${module}_${M_PART} ${module})
    string(APPEND module "_${M_PART}")
  else()
    file(GLOB_RECURSE headers CONFIGURE_DEPENDS "${folder}/*.h")
    fusee_check_layering(${module} "${M_USES}")
  endif()
  add_library(fusee_${module} STATIC ${M_SOURCES})
  add_library(fusee::${module} ALIAS fusee_${module})
  # One set of objects serves the program and Python's module, which is a shared library. g++ must not keep every function replaceable for that:
  # it would inline fewer.
  set_target_properties(fusee_${module} PROPERTIES EXPORT_NAME ${module} VERIFY_INTERFACE_HEADER_SETS ON POSITION_INDEPENDENT_CODE ON)
  target_compile_options(fusee_${module} PRIVATE -fno-semantic-interposition)
  target_sources(fusee_${module} PUBLIC FILE_SET HEADERS BASE_DIRS "${PROJECT_SOURCE_DIR}/include" FILES ${headers})
  foreach(used IN LISTS M_USES)
    if(NOT TARGET fusee_${used})
      message(FATAL_ERROR "module '${module}' uses '${used}', which is not on a floor below it")
    endif()
    target_link_libraries(fusee_${module} PUBLIC fusee::${used})
  endforeach()
  target_link_libraries(fusee_${module} PUBLIC fusee_options ${M_LINKS} PRIVATE ${M_PRIVATE_LINKS})
  target_include_directories(fusee_${module} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")  # for the sources in sub-folders
  if(DEFINED M_UNITY AND FUSEE_UNITY)
    set_target_properties(fusee_${module} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${M_UNITY})
  endif()
  if(DEFINED M_OPTIMIZE)
    target_compile_options(fusee_${module} PRIVATE $<$<CONFIG:Release>:-O${M_OPTIMIZE}>)
  endif()
  install(TARGETS fusee_${module} EXPORT fuseeTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev
          FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev)
endfunction()

# fusee_parts(report page design ...): fusee::report, all parts of the module, with the headers that none has; its private headers may include
# what any part USES.
function(fusee_parts module)
  foreach(part IN LISTS ARGN)
    if(NOT TARGET fusee_${module}_${part})
      return()  # left out
    endif()
  endforeach()
  add_library(fusee_${module} INTERFACE)
  add_library(fusee::${module} ALIAS fusee_${module})
  set_target_properties(fusee_${module} PROPERTIES EXPORT_NAME ${module})
  list(TRANSFORM ARGN PREPEND "fusee::${module}_" OUTPUT_VARIABLE parts)
  target_link_libraries(fusee_${module} INTERFACE ${parts})
  get_property(uses GLOBAL PROPERTY fusee_uses_of_${module})
  fusee_check_layering(${module} "${uses}")
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/include/fusee/${module}/*.h")
  foreach(part IN LISTS ARGN)
    get_target_property(of_part fusee_${module}_${part} HEADER_SET)
    list(REMOVE_ITEM headers ${of_part})
  endforeach()
  set_target_properties(fusee_${module} PROPERTIES VERIFY_INTERFACE_HEADER_SETS ON)
  target_sources(fusee_${module} INTERFACE FILE_SET HEADERS BASE_DIRS "${PROJECT_SOURCE_DIR}/include" FILES ${headers})
  install(TARGETS fusee_${module} EXPORT fuseeTargets FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev)
endfunction()

# fusee_loaded_library(nsga2 search SOURCES nsga2.cpp LINKS fusee::core Pagmo::pagmo): the shared library fusee_nsga2.so, which the module
# search loads when it needs it (core::loaded_function). Nothing of it is seen but its functions with C linkage.
function(fusee_loaded_library name module)
  cmake_parse_arguments(L "" "" "SOURCES;LINKS" ${ARGN})
  add_library(fusee_${name} MODULE ${L_SOURCES})
  set_target_properties(fusee_${name} PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}/fusee"
                        CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON UNITY_BUILD ${FUSEE_UNITY} UNITY_BUILD_BATCH_SIZE 0)
  target_include_directories(fusee_${name} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
  target_link_libraries(fusee_${name} PRIVATE ${L_LINKS} fusee_options)
  target_link_options(fusee_${name} PRIVATE -Wl,--exclude-libs,ALL)
  add_dependencies(fusee_${module} fusee_${name})
  set_property(GLOBAL APPEND PROPERTY fusee_loaded_libraries fusee_${name})
  install(TARGETS fusee_${name} LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}/fusee" COMPONENT program)
endfunction()

# Every `#include "fusee/X/..."` of a module must name the module itself or one that it declares in USES, and no include may climb
# out of its folder, which would go round that rule. Linking is transitive, including is not. A third argument names the files to check.
function(fusee_check_layering module uses)
  set(files ${ARGN})
  if(NOT files)
    file(GLOB_RECURSE files CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/include/fusee/${module}/*.h"
         "${PROJECT_SOURCE_DIR}/src/${module}/*.cpp" "${PROJECT_SOURCE_DIR}/src/${module}/*.h")
  endif()
  set(allowed ${module} ${uses})
  foreach(used IN LISTS uses)  # a part: its module
    get_property(whole GLOBAL PROPERTY fusee_module_of_${used})
    list(APPEND allowed ${whole})
  endforeach()
  foreach(file IN LISTS files)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
    file(STRINGS "${file}" lines REGEX "^[ \t]*#[ \t]*include[ \t]*([\"<]fusee/|\"[^\"]*\\.\\./)")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^[^\"<]*[\"<]fusee/([a-z_]+)/.*" "\\1" other "${line}")
      if(line MATCHES "\\.\\./" OR NOT other IN_LIST allowed)
        string(STRIP "${line}" line)
        message(FATAL_ERROR "${file}: module '${module}' (USES ${uses}) may not have: ${line}")
      endif()
    endforeach()
  endforeach()
endfunction()
