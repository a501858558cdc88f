# Frames and contact sheets of the air, added to windrow_cli_support. Cairo draws, windrow_pictures writes.
find_package(PkgConfig REQUIRED)
pkg_check_modules(cairo REQUIRED IMPORTED_TARGET cairo)

target_sources(windrow_cli_support PRIVATE
  drawing/canvas.cpp
  drawing/contact_sheet.cpp
  drawing/frame.cpp
  drawing/layout.cpp
  drawing/legend.cpp
  drawing/motor_marks.cpp
  drawing/outline.cpp
  drawing/overlay.cpp
  drawing/sections.cpp
  drawing/slice.cpp
  drawing/streamlines.cpp)
target_link_libraries(windrow_cli_support PRIVATE PkgConfig::cairo PUBLIC windrow_pictures)
