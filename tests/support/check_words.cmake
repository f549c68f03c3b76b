# Words that docs/glossary.md has retired do not come back. Run with -DROOT=<project>.
cmake_minimum_required(VERSION 3.21)
set(retired kMost[A-Z] kLeast[A-Z] "kMost[^A-Za-z]" "kLeast[^A-Za-z]" PairAgenda PairRest LiveRest ObjectReach PairPast takeStock seekRivals
  nastyPose nastyBodies SurfacePool SampleCover SurfaceSpread ShellBalance searchOtherWay setReach partReach Crease kPutOff kRested kAskFirst mostMotion seekLine keepLine bringUp catchUp BalancePoint
  walkWitness hiddenWays lookFromAbove mayRest "[^\"]put_off" "[^a-z_\"]most_[a-z]" "[^a-z_.\"]least_[a-z]"
  "[^a-zA-Z_]way[(]" "[^a-z]way_[^a-z]" "[\"]way [[]" "of_least" "take[A-Z]?[a-z]*Least[^a-z]")
# Phrases of messages and help texts that have been reworded.
list(APPEND retired "found nobody" "found beside" "times that rise" "metres a unit" "not known of their places" "off on the mean square" "RMS off"
  "judged too" "of your own\"" "taken already" "those found are" "those of a mirror" "closest to a person" "deepest inside" "goes on by itself"
  "stand yet\"" "is an input too" "than it says" "would have missed no" "broken YAML" "knows the names" "touching or not" "missed of touching"
  "bounds broken" "whoever is there" "whole frames are")
string(JOIN "|" pattern ${retired})
set(read 0)
foreach(folder core humanmodel tracking ui app tests include examples)
  file(GLOB_RECURSE files "${ROOT}/${folder}/*.hpp" "${ROOT}/${folder}/*.cpp" "${ROOT}/${folder}/*.inl")
  foreach(file IN LISTS files)
    math(EXPR read "${read} + 1")
    file(STRINGS "${file}" lines REGEX "${pattern}")
    foreach(line IN LISTS lines)
      message(SEND_ERROR "${file}: a word that docs/glossary.md has retired: ${line}")
    endforeach()
  endforeach()
endforeach()
if(read EQUAL 0)
  message(FATAL_ERROR "no source file found below ${ROOT}")
endif()
message(STATUS "${read} files use no retired word")
