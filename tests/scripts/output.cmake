# A short real run with all fields against the description of its files: read by h5py, an XML parser, csv and jsonschema.
add_test(NAME script.output
         COMMAND sh -c "$<TARGET_FILE:scree> run ${CMAKE_SOURCE_DIR}/examples/01_taylor_green_agglomeration/case.toml -o output --force --quiet --until 0.003 --set particles.grains.count=2000 --set output.frames=0.001 --set output.tracks=[0,1500] --set 'output.fields=[\"velocity\",\"angular_velocity\",\"diameter\",\"mass\",\"material\",\"group\",\"agglomerate\",\"agglomerate_size\",\"force\",\"unwrapped_position\",\"effect_diameter\",\"contacts\"]' && /usr/bin/python3 -B ${CMAKE_SOURCE_DIR}/tests/python/check_output.py output ${CMAKE_SOURCE_DIR}/docs/files.md"
         WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
set_tests_properties(script.output PROPERTIES LABELS quick ENVIRONMENT OMP_WAIT_POLICY=passive)
