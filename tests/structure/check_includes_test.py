#!/usr/bin/env python3
"""Plants faults in a small tree and asks check_includes.py to find each of them, and nothing in the tree without them."""
import pathlib
import tempfile
import unittest

import check_includes

CLEAN = {
    "shaders/numerics/base.glsl": "float f(float x) { return x; }\n",
    "shaders/numerics/motors.glsl": '#include "base.glsl"\n',
    "fluid/wind.h": "#include <glm/vec3.hpp>\n",
    "fluid/core/message.h": "",
    "fluid/cpu/step.cpp": '#include "fluid/wind.h"\n#include "fluid/core/message.h"\n#include "shaders/numerics/motors.glsl"\n',
    "fluid/cpu/cells.h": "",
    "fluid/core/wind_core.h": '#include "fluid/solids/solids.h"\n',
    "fluid/solids/solids.h": '#include "fluid/grid/halo.h"\n#include "fluid/core/message.h"\n',
    "fluid/grid/halo.h": "",
    "fluid/files/pgm.cpp": '#include "fluid/core/message.h"\n',
    "fluid/wind_state.h": '#include "fluid/cpu/cells.h"\n#include "fluid/core/wind_core.h"\n',
    "fluid/vulkan/air.cpp": '#include "gpu/device.h"\n#include "fluid/solids/solids.h"\n',
    "cases/reference/stam.h": '#include "fluid/cpu/cells.h"\n',
    "fluid/vdb/vdb_export.cpp": "#include <openvdb/openvdb.h>\n",
    "gpu/device.h": "#include <vulkan/vulkan.h>\n",
    "coupling/blade.h": '#include "../fluid/wind.h"\n',
    "scene/scene.h": '#include "fluid/core/message.h"\n#include "coupling/blade.h"\n',
    "pictures/picture.h": "",
    "pictures/picture_files.h": '#include "pictures/picture.h"\n#include "fluid/wind.h"\n',
    "pictures/picture_files.cpp": '#include "pictures/picture_files.h"\n#include <OpenImageIO/imageio.h>\n',
    "cases/flow.h": '#include "fluid/wind.h"\n',
    "cases/reference/vdb_poisson.cpp": "#include <openvdb/openvdb.h>\n",
    "cli/pictures.cpp": '#include "pictures/picture_files.h"\n#include "cases/flow.h"\n',
    "cli/device_report/meadow.cpp": '#include "vegetation/render/renderer.h"\n',
    "shaders/fluid/step.comp": '#include "../numerics/base.glsl"\n',
    "vegetation/shaders/numerics/grass.glsl": '#include "shaders/numerics/base.glsl"\n',
    "vegetation/render/renderer.h": '#include "../../coupling/blade.h"\n#include "../../pictures/picture.h"\n'
                                    '#include <vulkan/vulkan_core.h>\n#include "../shaders/numerics/grass.glsl"\n',
    "vegetation/render/hidden.h": "",
    "vegetation/files/mesh_file.cpp": "#include <tiny_gltf.h>\n#include <nlohmann/json.hpp>\n#include <OpenImageIO/imageio.h>\n",
    "vegetation/program/program.h": '#include "scene/scene.h"\n#include "pictures/picture_files.h"\n',
    "vegetation/tests/render/light_test.cpp": '#include "tests/figure.h"\n#include "vegetation/program/program.h"\n',
    "tests/figure.h": "",
    "tools/make_ground.py": "import math\n",
    "examples/walk.cpp": '#include <windrow/fluid/wind.h>\n#include "vegetation/render/renderer.h"\n#include <vulkan/vulkan.h>\n',
    "vegetation/render/sky.cpp": 'const char* row = "by vkAllocateMemory"; // and vkCreateBuffer\n',
    "tests/unit/step_test.cpp": '#include "fluid/cpu/step.h"\n#include <openvdb/openvdb.h>\n',
    "cmake/public_headers.txt": "# comment\nfluid/wind.h\ncoupling/blade.h\n",
}

FAULTS = {
    "the GPU looks into the CPU": ("fluid/vulkan/air.cpp", '#include "fluid/cpu/cells.h"\n'),
    "the CPU looks into the GPU": ("fluid/cpu/step.cpp", '#include "gpu/device.h"\n'),
    "the core looks into the CPU": ("fluid/core/wind_core.h", '#include "fluid/cpu/cells.h"\n'),
    "an installed file looks into the CPU": ("fluid/motors.cpp", '#include "fluid/cpu/cells.h"\n'),
    "a case looks into the CPU": ("cases/flow.h", '#include "fluid/cpu/cells.h"\n'),
    "the grid looks into the solids": ("fluid/grid/halo.h", '#include "fluid/solids/solids.h"\n'),
    "solids look into the core": ("fluid/solids/solids.h", '#include "fluid/core/wind_core.h"\n'),
    "files look into the core": ("fluid/files/pgm.cpp", '#include "fluid/core/wind_core.h"\n'),
    "the GPU layer looks into the wind": ("gpu/device.h", '#include "fluid/core/wind_core.h"\n'),
    "the renderer looks into the wind of a device": ("vegetation/render/renderer.h", '#include "fluid/vulkan/air.h"\n'),
    "scene looks into the GPU": ("scene/scene.h", '#include "gpu/device.h"\n'),
    "numerics includes a C++ header": ("shaders/numerics/base.glsl", "#include <glm/glm.hpp>\n"),
    "numerics includes another folder": ("shaders/numerics/base.glsl", '#include "../fluid/advect.glsl"\n'),
    "numerics includes the library": ("shaders/numerics/base.glsl", '#include "fluid/wind.h"\n'),
    "fluid includes coupling": ("fluid/cpu/step.cpp", '#include "coupling/blade.h"\n'),
    "fluid includes coupling by a relative path": ("fluid/cpu/step.cpp", '#include "../../coupling/blade.h"\n'),
    "fluid includes cli": ("fluid/wind.h", '#include "cli/pictures.h"\n'),
    "fluid includes scene": ("fluid/wind.h", '#include "scene/scene.h"\n'),
    "coupling includes scene": ("coupling/blade.h", '#include "scene/scene.h"\n'),
    "scene includes cli": ("scene/scene.h", '#include "cli/pictures.h"\n'),
    "scene includes examples": ("scene/scene.h", '#include "examples/walk.h"\n'),
    "fluid includes examples": ("fluid/wind.h", '  #  include "examples/walk.h"\n'),
    "Vulkan in the core": ("fluid/wind.h", "#include <vulkan/vulkan.h>\n"),
    "Vulkan in the command": ("cli/pictures.cpp", "#include <vulkan/vulkan_core.h>\n"),
    "OpenVDB in the core": ("fluid/cpu/step.cpp", "#include <openvdb/Grid.h>\n"),
    "OpenVDB in a header": ("fluid/vdb/vdb_export.h", "#include <openvdb/Types.h>\n"),
    "OpenVDB in the command": ("cli/pictures.cpp", "#include <openvdb/openvdb.h>\n"),
    "OpenVDB in a second translation unit": ("fluid/vdb/vdb_import.cpp", "#include <openvdb/openvdb.h>\n"),
    "OpenImageIO in the library": ("coupling/blade.h", "#include <OpenImageIO/imageio.h>\n"),
    "OpenImageIO in the command": ("cli/pictures.cpp", "#include <OpenImageIO/imageio.h>\n"),
    "a public header is found by the folder's name": ("coupling/blade.h", '#include "fluid/wind.h"\n'),
    "a public header finds formulas by the folder's name": ("coupling/blade.h", '#include "shaders/numerics/base.glsl"\n'),
    "an example writes the project's own name": ("examples/walk.cpp", '#include "fluid/wind.h"\n'),
    "an example looks inside by the user's name": ("examples/walk.cpp", '#include <windrow/fluid/message.h>\n'),
    "an example looks inside": ("examples/walk.cpp", '#include "fluid/cpu/step.h"\n'),
    "an example uses a private header": ("examples/walk.cpp", '#include "fluid/core/message.h"\n'),
    "an example uses the renderer as if installed": ("examples/walk.cpp", "#include <windrow/vegetation/render/renderer.h>\n"),
    "an example uses the renderer's files": ("examples/walk.cpp", '#include "vegetation/files/mesh_file.h"\n'),
    "an example uses windrow-draw's program": ("examples/walk.cpp", '#include "vegetation/program/program.h"\n'),
    "an example uses scene files": ("examples/walk.cpp", '#include "scene/scene.h"\n'),
    "fluid includes vegetation": ("fluid/wind.h", '#include "../vegetation/shaders/numerics/grass.glsl"\n'),
    "fluid includes tests": ("fluid/cpu/step.cpp", '#include "tests/figure.h"\n'),
    "coupling includes tests": ("coupling/blade.h", '#include "tests/figure.h"\n'),
    "scene includes tests": ("scene/scene.h", '#include "tests/figure.h"\n'),
    "pictures include tests": ("pictures/picture_files.cpp", '#include "tests/figure.h"\n'),
    "cases include tests": ("cases/flow.h", '#include "tests/figure.h"\n'),
    "cases include tests by a relative path": ("cases/reference/vdb_poisson.cpp", '#include "../../tests/figure.h"\n'),
    "cases include the command": ("cases/flow.h", '#include "cli/pictures.h"\n'),
    "the command includes tests": ("cli/pictures.cpp", '#include "tests/bench/reference/stam.h"\n'),
    "an example includes tests": ("examples/walk.cpp", '#include "tests/figure.h"\n'),
    "a shader includes tests": ("shaders/fluid/step.comp", '#include "../../tests/figure.h"\n'),
    "vegetation's program includes tests": ("vegetation/program/program.h", '#include "tests/figure.h"\n'),
    "fluid includes cases": ("fluid/wind.h", '#include "cases/flow.h"\n'),
    "the command includes vegetation": ("cli/pictures.cpp", '#include "vegetation/render/renderer.h"\n'),
    "the report of a device includes vegetation's files": ("cli/device_report/meadow.cpp", '#include "vegetation/files/mesh_file.h"\n'),
    "pictures include coupling": ("pictures/picture_files.cpp", '#include "coupling/blade.h"\n'),
    "vegetation includes the command": ("vegetation/program/program.h", '#include "cli/pictures.h"\n'),
    "vegetation includes tests": ("vegetation/render/hidden.h", '#include "tests/figure.h"\n'),
    "the vegetation library includes scene": ("vegetation/render/hidden.h", '#include "scene/scene.h"\n'),
    "the vegetation library includes JSON": ("vegetation/render/hidden.h", "#include <nlohmann/json.hpp>\n"),
    "the vegetation library includes picture files": ("vegetation/render/hidden.h", '#include "pictures/picture_files.h"\n'),
    "the vegetation library includes its program": ("vegetation/render/hidden.h", '#include "vegetation/program/program.h"\n'),
    "numerics of vegetation include a pass": ("vegetation/shaders/numerics/grass.glsl", '#include "../render/frame.glsl"\n'),
    "a public header includes the renderer": ("coupling/blade.h", '#include "../vegetation/render/renderer.h"\n'),
    "a script of 501 lines": ("tools/make_ground.py", "\n" * 501),
    "an example uses the command": ("examples/walk.cpp", '#include "cli/pictures.h"\n'),
    "a public header includes a private one": ("fluid/wind.h", '#include "fluid/core/message.h"\n'),
    "a public header needs a library": ("fluid/wind.h", "#include <boost/optional.hpp>\n"),
    "a public header that there is not": ("cmake/public_headers.txt", "fluid/ocean.h\n"),
    "an example makes a pipeline": ("examples/walk.cpp", "vkCreateGraphicsPipelines(device);\n"),
    "a buffer beside the layer": ("vegetation/render/sky.cpp", "must(vkAllocateMemory(device));\n"),
    "a file of 501 lines": ("fluid/wind.h", "\n" * 501),
}


class CheckIncludes(unittest.TestCase):
    def breaches(self, extra=None):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in CLEAN.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            if extra:
                name, text = extra
                with open(root / name, "a", encoding="utf-8") as file:
                    file.write(text)
            count, found = check_includes.check(root)
            self.assertGreater(count, 0)
            return found

    def test_a_clean_tree_has_none(self):
        self.assertEqual(self.breaches(), [])

    def test_each_planted_fault_is_found_once_and_named(self):
        for what, fault in FAULTS.items():
            with self.subTest(what):
                found = self.breaches(fault)
                self.assertEqual(len(found), 1, found)
                self.assertTrue(found[0].startswith(fault[0] + ":"), found)


if __name__ == "__main__":
    unittest.main()
