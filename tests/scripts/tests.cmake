# SPDX-License-Identifier: Apache-2.0
# The scripts that a user types.
find_program(HAPTICUT_BASH bash)
mark_as_advanced(HAPTICUT_BASH)
function(hapticut_script_test name case)
  add_test(NAME Scripts.${name}
    COMMAND "${HAPTICUT_BASH}" "${PROJECT_SOURCE_DIR}/tests/scripts/scripts_test.sh" "${PROJECT_SOURCE_DIR}" ${case})
  set_tests_properties(Scripts.${name} PROPERTIES LABELS scripts TIMEOUT 300)
endfunction()
hapticut_script_test(ExplainEveryOption help)
hapticut_script_test(RefuseUnknownOptionsInOneLine unknown)
hapticut_script_test(ListPackagesOneALine list)
hapticut_script_test(SayNothingWhenNothingIsMissing nothing_missing)
hapticut_script_test(NameWhatIsMissingWithoutInstallingIt check)
hapticut_script_test(InstallOnlyWhatIsMissing install)
hapticut_script_test(SayInOneLineWhatCannotBeInstalled cannot_install)
hapticut_script_test(CountEveryTestOfEveryProgramOnce count)
hapticut_script_test(OfTheDemoBuildAndDrillBothWorkpieces demo)
