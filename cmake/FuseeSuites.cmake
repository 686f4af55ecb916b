# fusee_discover_suites(test_cam "cam."): each suite of a test program is one test of ctest, "cam.Arm". The tests of a suite share what they
# make, and the program is started once a suite. A suite of which tests are skipped counts as skipped, unless another of its tests fails.
if(NOT PROGRAM)
  set(FUSEE_SUITES_SCRIPT "${CMAKE_CURRENT_LIST_FILE}")
  function(fusee_discover_suites target prefix)
    set(list "${CMAKE_CURRENT_BINARY_DIR}/${target}_suites.cmake")
    add_custom_command(TARGET ${target} POST_BUILD BYPRODUCTS "${list}" VERBATIM
      COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=$<TARGET_FILE:${target}>" "-DPREFIX=${prefix}" "-DLIST=${list}" "-DSLOW=${FUSEE_SLOW_TESTS}" -P "${FUSEE_SUITES_SCRIPT}")
    file(WRITE "${list}.in.cmake" "if(EXISTS \"${list}\")\n  include(\"${list}\")\nelse()\n  add_test(${prefix}NOT_BUILT NOT_BUILT)\nendif()\n")
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${list}.in.cmake")
  endfunction()
  return()
endif()

execute_process(COMMAND "${PROGRAM}" --gtest_list_tests OUTPUT_VARIABLE listed RESULT_VARIABLE result TIMEOUT 60)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} does not list its tests: ${result}\n${listed}")
endif()
string(REGEX MATCHALL "\n[A-Za-z0-9_/]+\\.[^\n]*" suites "\n${listed}")
set(tests "")
foreach(suite IN LISTS suites)
  string(REGEX REPLACE "^\n([A-Za-z0-9_/]+)\\..*" "\\1" name "${suite}")
  set(label fast)
  if("${PREFIX}${name}" MATCHES "${SLOW}")
    set(label slow)
  endif()
  # gtest lists what was skipped after what passed, and what failed last.
  string(APPEND tests "add_test([=[${PREFIX}${name}]=] [=[${PROGRAM}]=] [=[--gtest_filter=${name}.*]=])\n"
    "set_tests_properties([=[${PREFIX}${name}]=] PROPERTIES SKIP_REGULAR_EXPRESSION [=[\\[  SKIPPED \\] [^[]*$]=] LABELS ${label})\n")
endforeach()
file(WRITE "${LIST}" "${tests}")
