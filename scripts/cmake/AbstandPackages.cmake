# Debian packages by CPack, one for each component: abstand (program), abstand-studio (studio), libabstand-dev (dev), python3-abstand
# (python). scripts/package builds them.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME abstand)
set(CPACK_PACKAGE_VENDOR "Abstand")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "distances and contact between people and robots")
set(CPACK_PACKAGE_CONTACT "Abstand developers <developers@abstand.example.org>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(same_version "(= ${PROJECT_VERSION}-1)")

# dpkg-shlibdeps finds the dependencies of programs and modules; those of the static libraries are listed here.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME abstand)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS assimp-testmodels)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "abstand-studio, libfreenect0.5, weasyprint")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "Computes for robotics labs and safety engineers, with stated error bounds,
how close a person came to a robot, how hard a contact would have been, and
which safety margin would have been sufficient. An analysis tool, not a
safety function.
.
This package contains the command line program, robots, scenes and joint maps.")
set(CPACK_DEBIAN_STUDIO_PACKAGE_NAME abstand-studio)
set(CPACK_DEBIAN_STUDIO_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_STUDIO_PACKAGE_DEPENDS "abstand ${same_version}, libgl1-mesa-dri")
set(CPACK_DEBIAN_STUDIO_PACKAGE_RECOMMENDS qttranslations5-l10n)
set(CPACK_COMPONENT_STUDIO_DESCRIPTION "The desktop program: shows people and robots in three dimensions with
distances, force arrows and live plots.")
set(CPACK_DEBIAN_DEV_PACKAGE_NAME libabstand-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "abstand ${same_version}, libassimp-dev, libconsole-bridge-dev, libeigen3-dev, libqhull-dev, \
liburdfdom-dev, libyaml-cpp-dev, zlib1g-dev")
set(CPACK_DEBIAN_DEV_PACKAGE_RECOMMENDS "libdeflate-dev, libhdf5-dev, libode-dev, libopencv-calib3d-dev, libopencv-core-dev, \
libopencv-imgproc-dev, libpcl-dev, libpng-dev, libtiff-dev")
set(CPACK_COMPONENT_DEV_DESCRIPTION "The library: distance of two bodies with a certified bound, contact
forces, kinematics of robots, people from recordings, and scenes of them.
.
Headers, static libraries and examples. The component Scene needs the
recommended packages.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-abstand)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${PROJECT_SOURCE_DIR}/scripts/debian/python3-abstand/postinst;${PROJECT_SOURCE_DIR}/scripts/debian/python3-abstand/prerm")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "abstand ${same_version}, python3, python3-numpy")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "The Python module: engine, robots, people and scenes with NumPy arrays.")

# Only components with files become packages.
get_cmake_property(CPACK_COMPONENTS_ALL COMPONENTS)
list(REMOVE_ITEM CPACK_COMPONENTS_ALL Unspecified)

find_program(GZIP gzip)
# abstand_compressed(FILE NAME DESTINATION COMPONENT): installs a compressed file without time stamps, as Debian policy requires.
function(abstand_compressed file name destination component)
  set(out ${PROJECT_BINARY_DIR}/package/${component}/${name})
  get_filename_component(folder ${out} DIRECTORY)
  file(MAKE_DIRECTORY ${folder})
  execute_process(COMMAND ${GZIP} -9nc ${PROJECT_SOURCE_DIR}/scripts/debian/${file} OUTPUT_FILE ${out} COMMAND_ERROR_IS_FATAL ANY)
  install(FILES ${out} DESTINATION ${destination} COMPONENT ${component})
endfunction()
if(GZIP)
  foreach(component IN LISTS CPACK_COMPONENTS_ALL)
    string(TOUPPER ${component} upper)
    set(folder ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
    install(FILES ${PROJECT_SOURCE_DIR}/scripts/debian/copyright DESTINATION ${folder} COMPONENT ${component})
    abstand_compressed(changelog changelog.Debian.gz ${folder} ${component})
  endforeach()
  abstand_compressed(abstand.1 abstand.1.gz ${CMAKE_INSTALL_MANDIR}/man1 program)
  if(ABSTAND_BUILD_UI)
    abstand_compressed(abstand-studio.1 abstand-studio.1.gz ${CMAKE_INSTALL_MANDIR}/man1 studio)
  endif()
endif()
include(CPack)
