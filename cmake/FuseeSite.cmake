# The documents as a site without external requests: `./fusee site` writes build/site, with sample pages (site/samples.sh) and, in
# build/site/api, the API reference; the program prints the tables of rules and keys (site/hooks.py). Not part of a build.
if(TARGET fusee_app)
  option(FUSEE_API_PARAMETERS "doxygen also warns of each parameter without a word" OFF)
  set(FUSEE_API_PARAMETERS_WORD NO)
  if(FUSEE_API_PARAMETERS)
    set(FUSEE_API_PARAMETERS_WORD YES)
  endif()
  configure_file("${CMAKE_CURRENT_LIST_DIR}/site/Doxyfile.in" "${PROJECT_BINARY_DIR}/Doxyfile" @ONLY)
  set(samples "${PROJECT_BINARY_DIR}/site-samples")
  add_custom_target(site
    COMMAND "${CMAKE_CURRENT_LIST_DIR}/site/samples.sh" "$<TARGET_FILE:fusee_app>" "${PROJECT_SOURCE_DIR}" "${samples}"
    COMMAND "${CMAKE_COMMAND}" -E env "FUSEE_PROGRAM=$<TARGET_FILE:fusee_app>" "FUSEE_SAMPLES=${samples}" mkdocs build --strict --quiet --clean --config-file "${PROJECT_SOURCE_DIR}/mkdocs.yml" --site-dir "${PROJECT_BINARY_DIR}/site"
    COMMAND doxygen "${PROJECT_BINARY_DIR}/Doxyfile"
    WORKING_DIRECTORY "${PROJECT_BINARY_DIR}" COMMENT "The documents as a site: site/index.html" VERBATIM)
endif()
