# Frames and contact sheets of the air, added to windrow_cli_support. Cairo draws, OpenImageIO writes.
#
# Both are found by pkg-config: OpenImageIO's own CMake package of Debian 12 names an OpenCV folder and tools that it does not bring.
find_package(PkgConfig REQUIRED)
pkg_check_modules(cairo REQUIRED IMPORTED_TARGET cairo)
pkg_check_modules(openimageio REQUIRED IMPORTED_TARGET OpenImageIO>=2.4)

target_sources(windrow_cli_support PRIVATE
  pictures.cpp
  drawing/axes.cpp
  drawing/canvas.cpp
  drawing/colour_bar.cpp
  drawing/colour_map.cpp
  drawing/contact_sheet.cpp
  drawing/frame.cpp
  drawing/layout.cpp
  drawing/legend.cpp
  drawing/motor_marks.cpp
  drawing/motor_style.cpp
  drawing/names.cpp
  drawing/outline.cpp
  drawing/overlay.cpp
  drawing/png.cpp
  drawing/slice.cpp
  drawing/text.cpp
  drawing/world_map.cpp
  pareto/plot_image.cpp)
target_link_libraries(windrow_cli_support PRIVATE PkgConfig::cairo PkgConfig::openimageio)
