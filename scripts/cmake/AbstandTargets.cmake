# Compile settings of all targets of the project.

# Flags of all own code. No fused multiply-add unless requested, so that results do not depend on the
# contractions of the compiler. Mathematical functions do not set errno, which nothing reads: loops with a square root can be vectorized.
add_library(abstand_flags INTERFACE)
target_compile_options(abstand_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -ffp-contract=off -fno-math-errno
  $<$<BOOL:${ABSTAND_WERROR}>:-Werror>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # Allows the same inlining in position-independent code as in other code; default of clang.
  target_compile_options(abstand_flags INTERFACE -fno-semantic-interposition)
endif()
if(ABSTAND_SANITIZE)
  target_compile_options(abstand_flags INTERFACE -fsanitize=${ABSTAND_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(abstand_flags INTERFACE -fsanitize=${ABSTAND_SANITIZE})
  if(ABSTAND_SANITIZE MATCHES undefined)
    # Checks that take a quarter of the compile time: the address sanitizer reports an access through a null or wrapped pointer, or
    # beyond an object, when it happens.
    target_compile_options(abstand_flags INTERFACE -fno-sanitize-recover=undefined -fno-sanitize=null,object-size,pointer-overflow)
  endif()
endif()

# External headers that nearly every file includes, precompiled once for all libraries, and once more with GoogleTest for all tests.
# This halves the build time. Files still include what they use.
set(abstand_common_headers <Eigen/Core> <Eigen/Geometry> <algorithm> <cmath> <functional> <memory> <optional> <span>
  <string> <vector>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # -fpch-preprocess is for the compiler cache. With precompiled headers, GCC 12 reports false bounds warnings in the strings of the
  # standard library (GCC bug 105651 and related ones); clang and the sanitizers check bounds.
  target_compile_options(abstand_flags INTERFACE -fpch-preprocess -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow)
  if(ABSTAND_UNITY)
    # For a private class with a member of an unnamed namespace, in a file that is compiled together with others.
    target_compile_options(abstand_flags INTERFACE -Wno-subobject-linkage)
  endif()
else()
  # So that the compiler cache identifies precompiled headers by content.
  target_compile_options(abstand_flags INTERFACE "SHELL:-Xclang -fno-pch-timestamp")
endif()

# abstand_library(NAME [sources] [LINKS libraries of the project]): a library with the alias abstand::NAME; static unless
# BUILD_SHARED_LIBS is set. The headers of a facade are those of include/; only these are installed.
function(abstand_library name)
  cmake_parse_arguments(L "" "" "LINKS" ${ARGN})
  add_library(abstand_${name} ${L_UNPARSED_ARGUMENTS})
  add_library(abstand::${name} ALIAS abstand_${name})
  target_include_directories(abstand_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
  if(name MATCHES "^facade_")
    target_include_directories(abstand_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
      $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  endif()
  target_compile_features(abstand_${name} PUBLIC cxx_std_20)
  # Position-independent for the Python module. No macro for shared libraries, because all libraries share the precompiled headers.
  # Until 1.0, the second number of the version also identifies the binary interface.
  set_target_properties(abstand_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON DEFINE_SYMBOL ""
    INSTALL_RPATH "$ORIGIN" VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  list(TRANSFORM L_LINKS PREPEND abstand::)
  target_link_libraries(abstand_${name} PUBLIC ${L_LINKS} Eigen3::Eigen Threads::Threads
    PRIVATE $<BUILD_INTERFACE:abstand_flags>)
  if(name STREQUAL engine)
    target_precompile_headers(abstand_engine PRIVATE ${abstand_common_headers})
  elseif(NOT name STREQUAL ui)
    target_precompile_headers(abstand_${name} REUSE_FROM abstand_engine)
  endif()
endfunction()

# abstand_fingerprint(TARGET HEADER NAME WHAT sources...): generates HEADER for the sources of the target, with the constant NAME, a hash
# of the contents of `sources` that does not depend on their times.
function(abstand_fingerprint target header name what)
  set(file ${PROJECT_BINARY_DIR}/generated/${header})
  add_custom_command(OUTPUT ${file}
    COMMAND ${CMAKE_COMMAND} "-DSOURCES=${ARGN}" -DNAME=${name} "-DWHAT=${what}" -DOUT=${file}
            -P ${PROJECT_SOURCE_DIR}/scripts/cmake/WriteFingerprint.cmake
    DEPENDS ${ARGN} ${PROJECT_SOURCE_DIR}/scripts/cmake/WriteFingerprint.cmake VERBATIM)
  add_custom_target(${target}_fingerprint DEPENDS ${file})
  add_dependencies(${target} ${target}_fingerprint)
  target_include_directories(${target} PRIVATE ${PROJECT_BINARY_DIR}/generated)
endfunction()

# s; ends tests that hang, and whole programs with a sanitizer. On a busy machine, some take minutes.
set(ABSTAND_TEST_TIMEOUT 900)
set(ABSTAND_SANITIZED_TIMEOUT 1800)

# Builds the test programs that start threads, for the thread sanitizer; their labels end with `_threads`.
add_custom_target(threaded_tests)

# abstand_test(NAME [THREADS] [SHARDS count] SOURCES files LIBS libraries): a GoogleTest program; each case is a test of ctest. With a
# sanitizer, the whole program or each of its shards is one test, because its start takes longer than most of its cases.
function(abstand_test name)
  cmake_parse_arguments(T "THREADS" "SHARDS" "SOURCES;LIBS;LABELS" ${ARGN})
  if(NOT T_SHARDS)
    set(T_SHARDS 1)
  endif()
  if(NOT T_LABELS)
    set(T_LABELS unit)
  endif()
  if(T_THREADS)
    set(T_LABELS ${T_LABELS}_threads)
    add_dependencies(threaded_tests ${name})
  endif()
  add_executable(${name} ${T_SOURCES})
  target_precompile_headers(${name} REUSE_FROM abstand_test_support)
  target_link_libraries(${name} PRIVATE ${T_LIBS} abstand_test_support GTest::gtest GTest::gmock abstand_flags)
  if(ABSTAND_SANITIZE)
    foreach(shard RANGE 1 ${T_SHARDS})
      math(EXPR index "${shard} - 1")
      add_test(NAME ${name}_${shard} COMMAND ${name})
      # Long tests start first, so that no core is idle at the end.
      set_tests_properties(${name}_${shard} PROPERTIES LABELS ${T_LABELS} COST ${T_SHARDS} TIMEOUT ${ABSTAND_SANITIZED_TIMEOUT}
        ENVIRONMENT "GTEST_TOTAL_SHARDS=${T_SHARDS};GTEST_SHARD_INDEX=${index}")
    endforeach()
  else()
    # Without the values of parameters, which gtest prints as bytes: they differ from run to run.
    gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60 NO_PRETTY_VALUES
      PROPERTIES LABELS ${T_LABELS} TIMEOUT ${ABSTAND_TEST_TIMEOUT} SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]")
  endif()
endfunction()

# abstand_group_sources(DIRECTORY): compiles the .cpp files of each target in groups of up to twelve, those of tests in groups of up to
# six, because headers that the files share take most of the time (docs/build-time.md). A group that is at least half full ends with its
# folder, so that a new file regroups few others. Names in unnamed namespaces have to be unique in a target; each test file has its own
# named namespace, because tests use the same names for tolerances. Call it after all targets are defined.
function(abstand_group_sources directory)
  get_property(folders DIRECTORY ${directory} PROPERTY SUBDIRECTORIES)
  # Its files are linked individually: the tests of the window have their own main function.
  list(REMOVE_ITEM folders ${PROJECT_SOURCE_DIR}/tests/support)
  foreach(folder IN LISTS folders)
    abstand_group_sources(${folder})
  endforeach()
  get_property(targets DIRECTORY ${directory} PROPERTY BUILDSYSTEM_TARGETS)
  set(group_size 12)
  if(directory MATCHES "^${PROJECT_SOURCE_DIR}/tests")
    set(group_size 6)
  endif()
  math(EXPR half "${group_size} / 2")
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(NOT type MATCHES "^(STATIC_LIBRARY|SHARED_LIBRARY|MODULE_LIBRARY|OBJECT_LIBRARY|EXECUTABLE)$")
      continue()
    endif()
    get_target_property(sources ${target} SOURCES)
    list(FILTER sources INCLUDE REGEX "\\.cpp$")
    get_target_property(home ${target} SOURCE_DIR)
    list(TRANSFORM sources PREPEND "${home}/" REGEX "^[^/]")
    list(SORT sources)
    set(last "")
    set(count ${group_size})
    foreach(source IN LISTS sources)
      get_filename_component(folder ${source} DIRECTORY)
      if(count EQUAL group_size OR (NOT folder STREQUAL last AND NOT count LESS half))
        string(MD5 group ${source})
        set(count 0)
      endif()
      set(last ${folder})
      math(EXPR count "${count} + 1")
      set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${group})
    endforeach()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  endforeach()
endfunction()
