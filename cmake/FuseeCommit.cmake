# cmake -DIN=build_name.cpp.in -DOUT=build_name.cpp -DSOURCE=FOLDER -DFUSEE_BUILD="Release, GNU 12.2.0" -P FuseeCommit.cmake
# Writes the name of the commit into a source; "no commit" for sources without git.
execute_process(COMMAND git -C "${SOURCE}" rev-parse --short=12 HEAD OUTPUT_VARIABLE FUSEE_COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
execute_process(COMMAND git -C "${SOURCE}" rev-parse --show-prefix OUTPUT_VARIABLE prefix OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT FUSEE_COMMIT OR prefix)  # a prefix: the sources stand inside another repository
  set(FUSEE_COMMIT "no commit")
endif()
configure_file("${IN}" "${OUT}" @ONLY)
file(TOUCH_NOCREATE "${OUT}")
