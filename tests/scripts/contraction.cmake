# -ffp-contract=off is not enough: where g++ 12 packs the cross products of a loop that it could not vectorise, it fuses
# multiplication and addition all the same, and the bits then depend on the instruction set.
if(TARGET sweep_avx2 AND CMAKE_OBJDUMP)
  add_test(NAME house.contraction
           COMMAND ${CMAKE_CURRENT_LIST_DIR}/contraction.sh ${CMAKE_OBJDUMP} $<TARGET_OBJECTS:sweep_baseline>
                   $<TARGET_OBJECTS:sweep_avx2> $<TARGET_OBJECTS:sweep_avx512>
           COMMAND_EXPAND_LISTS)
  set_tests_properties(house.contraction PROPERTIES LABELS quick)
endif()
