# Targets for those who work on fusee; each is there only where its tool is.
# Other versions of clang-format lay out some lines differently, so only Debian 12's counts.
find_program(CLANG_FORMAT_PROGRAM NAMES clang-format-14 clang-format)
if(CLANG_FORMAT_PROGRAM)
  add_custom_target(format COMMAND "${PROJECT_SOURCE_DIR}/tests/house/format_test.sh" "${CLANG_FORMAT_PROGRAM}" --fix
                    COMMENT "Formatting include, src and tests" VERBATIM)
endif()
find_program(GCOVR_PROGRAM gcovr)
if(GCOVR_PROGRAM)
  add_custom_target(coverage COMMAND "${GCOVR_PROGRAM}" --root "${PROJECT_SOURCE_DIR}" --filter "${PROJECT_SOURCE_DIR}/src/"
                    --filter "${PROJECT_SOURCE_DIR}/include/" --print-summary --html-details coverage.html
                    WORKING_DIRECTORY "${PROJECT_BINARY_DIR}" COMMENT "Which lines the tests reached: coverage.html" VERBATIM)
endif()

# The pictures of README and docs that `fusee render` draws.
if(TARGET fusee_app)
  add_custom_target(docs_pictures
    COMMAND fusee_app render "${PROJECT_SOURCE_DIR}/profiles/pnrvsa.toml" --view cams -o "${PROJECT_SOURCE_DIR}/docs/images/cams.png" --force
    COMMAND fusee_app render "${PROJECT_SOURCE_DIR}/profiles/pnrvsa.toml" --view motion -o "${PROJECT_SOURCE_DIR}/docs/images/joint.png" --width 480 --force
    COMMAND fusee_app render "${PROJECT_SOURCE_DIR}/profiles/pnrvsa.toml" --view exploded -o "${PROJECT_SOURCE_DIR}/docs/images/exploded.png" --width 1000 --force
    COMMAND fusee_app render "${PROJECT_SOURCE_DIR}/profiles/pnrvsa.toml" --view dead-band -o "${PROJECT_SOURCE_DIR}/docs/images/dead_band.svg" --force
    VERBATIM)
endif()
