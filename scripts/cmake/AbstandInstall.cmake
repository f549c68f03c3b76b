# Installation of programs and data, and of the library for find_package(Abstand) and pkg-config.
include(CMakePackageConfigHelpers)

set(abstand_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/Abstand)

# abstand_export(COMPONENT targets...): exports the libraries of a component; NAME=TARGET sets the exported name.
function(abstand_export component)
  set(targets "")
  foreach(word IN LISTS ARGN)
    string(REPLACE "=" ";" pair ${word})
    list(POP_FRONT pair name)
    set(target abstand_${name})
    if(pair)
      set(target abstand_${pair})
    endif()
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
    list(APPEND targets ${target})
  endforeach()
  install(TARGETS ${targets} EXPORT Abstand${component}Targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev NAMELINK_COMPONENT dev)
  install(EXPORT Abstand${component}Targets NAMESPACE Abstand:: DESTINATION ${abstand_cmake_dir} COMPONENT dev)
endfunction()

# Targets with a capital letter are for users; the others are their dependencies.
abstand_export(Engine engine Engine=facade_engine)
abstand_export(Mechanism mechanism Mechanism=facade_mechanism)
abstand_export(Human humanmodel Human=facade_human)
abstand_export(Tracking config scene body tracking Tracking=facade_tracking)
abstand_export(Scene physics verify depth tracker app Scene=facade_scene)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/abstand DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev
  FILES_MATCHING PATTERN "*.hpp")
set(abstand_static ON)
if(BUILD_SHARED_LIBS)
  set(abstand_static OFF)
endif()
configure_package_config_file(${PROJECT_SOURCE_DIR}/scripts/cmake/AbstandConfig.cmake.in
  ${PROJECT_BINARY_DIR}/package/AbstandConfig.cmake INSTALL_DESTINATION ${abstand_cmake_dir}
  PATH_VARS CMAKE_INSTALL_DATADIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/AbstandConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/package/AbstandConfig.cmake ${PROJECT_BINARY_DIR}/package/AbstandConfigVersion.cmake
  ${PROJECT_SOURCE_DIR}/scripts/cmake/FindODE.cmake DESTINATION ${abstand_cmake_dir} COMPONENT dev)

# abstand_pkg_config(NAME DESCRIPTION LIBRARIES packages...): NAME.pc; a static library also requires its dependencies.
function(abstand_pkg_config name description libraries)
  cmake_parse_arguments(P "" "" "REQUIRES;PRIVATE;SYSTEM" ${ARGN})
  set(libs "")
  foreach(library IN LISTS libraries)
    string(APPEND libs " -labstand_${library}")
  endforeach()
  list(JOIN P_REQUIRES ", " requires)
  list(JOIN P_PRIVATE ", " private)
  list(JOIN P_SYSTEM " " system)
  if(abstand_static AND private)
    string(APPEND requires ", ${private}")
  endif()
  if(abstand_static)
    string(APPEND libs " ${system}")
  endif()
  file(WRITE ${PROJECT_BINARY_DIR}/package/${name}.pc
"prefix=\${pcfiledir}/${abstand_pc_up}
libdir=\${prefix}/${CMAKE_INSTALL_LIBDIR}
includedir=\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}

Name: ${name}
Description: ${description}
Version: ${PROJECT_VERSION}
Requires: ${requires}
Libs: -L\${libdir}${libs}
Cflags: -I\${includedir}
")
  install(FILES ${PROJECT_BINARY_DIR}/package/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT dev)
endfunction()
file(RELATIVE_PATH abstand_pc_up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" abstand_pc_up "${abstand_pc_up}")
abstand_pkg_config(abstand-engine "Distances and contact of two bodies, with certified bounds" "facade_engine;engine"
  REQUIRES eigen3 PRIVATE assimp qhull_r SYSTEM -lpthread)
abstand_pkg_config(abstand-mechanism "Kinematics of robots in URDF and Denavit-Hartenberg tables" "facade_mechanism;mechanism"
  REQUIRES abstand-engine PRIVATE urdfdom console_bridge)
abstand_pkg_config(abstand-human "Parametric people of fourteen rigid parts" "facade_human;humanmodel" REQUIRES abstand-engine)
abstand_pkg_config(abstand-tracking "Recordings of people" "facade_tracking;tracking;body;scene;config"
  REQUIRES abstand-human abstand-mechanism PRIVATE zlib SYSTEM -lyaml-cpp)
# The Debian packages of single OpenCV modules contain no file for pkg-config.
abstand_pkg_config(abstand-scene "Scenes of people and robots, frame by frame" "facade_scene;app;tracker;depth;verify;physics"
  REQUIRES abstand-tracking PRIVATE ode pcl_registration pcl_filters pcl_search pcl_sample_consensus pcl_common hdf5-serial libdeflate
  SYSTEM -lopencv_calib3d -lopencv_imgproc -lopencv_core -lpng -ltiff -ldl)

# Programs, data and documents.
if(BUILD_SHARED_LIBS)
  file(RELATIVE_PATH to_libraries ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  set_target_properties(abstand PROPERTIES INSTALL_RPATH "$ORIGIN/${to_libraries}")
endif()
install(TARGETS abstand RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/data/ DESTINATION ${CMAKE_INSTALL_DATADIR}/abstand COMPONENT program)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program
  FILES_MATCHING PATTERN "*.md" PATTERN "pictures" EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libabstand-dev COMPONENT dev)
if(ABSTAND_BUILD_UI)
  install(TARGETS abstand-studio RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT studio)
  install(FILES ${PROJECT_SOURCE_DIR}/scripts/debian/abstand.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications
    COMPONENT studio)
  install(FILES ${PROJECT_SOURCE_DIR}/scripts/debian/abstand-studio.svg
    DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT studio)
  install(FILES ${PROJECT_SOURCE_DIR}/scripts/debian/abstand-studio.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages
    COMPONENT studio)
endif()

# The API documentation, if doxygen is available; installed if it was built.
add_custom_target(docs COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR} -DOUT=${PROJECT_BINARY_DIR}/api
  -DVERSION=${PROJECT_VERSION} -P ${PROJECT_SOURCE_DIR}/scripts/cmake/ApiDocs.cmake VERBATIM)
install(DIRECTORY ${PROJECT_BINARY_DIR}/api/html DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libabstand-dev/api COMPONENT dev OPTIONAL)
