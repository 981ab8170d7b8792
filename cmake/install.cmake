# What belongs to facet on a system, and the packages that bring it there: cmake --install, cpack.

include(GNUInstallDirs)
set(desktop ${PROJECT_SOURCE_DIR}/resources/desktop)

install(TARGETS facet facet_shared)
set(library ${PROJECT_SOURCE_DIR}/src/library)
install(FILES ${library}/facet.h ${library}/facet.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES ${library}/facet.py DESTINATION lib/python3/dist-packages)  # where Debian's Python looks below /usr
install(FILES ${library}/example.c DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples)
file(RELATIVE_PATH facet_up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(${library}/facet.pc.in ${PROJECT_BINARY_DIR}/facet.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/facet.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
install(FILES ${desktop}/facet.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${desktop}/facet.thumbnailer DESTINATION ${CMAKE_INSTALL_DATADIR}/thumbnailers)
install(FILES ${desktop}/facet.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)
install(FILES ${desktop}/facet.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
foreach(size 48 256)
  install(FILES ${desktop}/facet-${size}.png RENAME facet.png
    DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/${size}x${size}/apps)
endforeach()
set(completion ${PROJECT_SOURCE_DIR}/resources/completion)
install(FILES ${completion}/facet.bash RENAME facet DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(CODE "
  set(folder site-functions)
  if(CMAKE_INSTALL_PREFIX STREQUAL \"/usr\" AND EXISTS /etc/debian_version)
    set(folder vendor-completions)  # where Debian's zsh looks for what packages bring
  endif()
  file(INSTALL \"${completion}/_facet\" TYPE FILE
    DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}/zsh/\${folder}\")")
install(FILES ${completion}/facet.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE RENAME copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})

# The program itself writes its manual.
set(manual ${PROJECT_BINARY_DIR}/manual)
install(CODE "
  file(REMOVE_RECURSE \"${manual}\")
  execute_process(COMMAND \"$<TARGET_FILE:facet>\" manual -o \"${manual}\" COMMAND_ERROR_IS_FATAL ANY)
  file(GLOB pages \"${manual}/*.1\")
  execute_process(COMMAND gzip -9n \${pages} COMMAND_ERROR_IS_FATAL ANY)")
install(DIRECTORY ${manual}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)

set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGE_VENDOR "the facet authors")
set(CPACK_PACKAGE_CONTACT "the facet authors <facet@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "viewer and headless renderer for glTF 2.0")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"A desktop viewer and headless renderer for glTF 2.0 that answers, beside every
picture: how wrong is it, and what did it cost? With a thumbnailer for file
managers, comparison of pictures and suites of pictures for CI.")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What is loaded by name: libepoxy looks for EGL and GLX, these for a driver.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libegl1, libgl1, libgl1-mesa-dri")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "shared-mime-info, desktop-file-utils, libavif${avif_version}")
include(CPack)
