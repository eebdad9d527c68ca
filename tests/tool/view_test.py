# SPDX-License-Identifier: BSD-3-Clause
"""Opens pages of `kith view` in Chromium and uses them as a reader would: view_test.py KITH [MESHES].

MESHES is a directory with elephant.off. The surfaces of a page are compared with those of the program, bit by bit.
"""
import os
import subprocess
import sys
import tempfile
import unittest

try:
    from selenium import webdriver
    from selenium.common.exceptions import WebDriverException
    from selenium.webdriver import ActionChains
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.support.ui import Select
except ImportError as missing:
    print("skipped:", missing)
    sys.exit(77)

KITH = sys.argv[1]
MESHES = sys.argv[2] if len(sys.argv) > 2 else ""
CUBE = ([(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)],
        [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)])
OCTAHEDRON = ([(1, 0, 0), (-1, 0, 0), (0, 1.1, 0), (0, -1, 0), (0, 0, 1.3), (0, 0, -1)],
              [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)])
OPEN = ([(0, 0, 0), (2, 0, 0.3), (2, 2, 0), (0, 2, 0.7), (1, 1, 1)], [(0, 1, 4), (1, 2, 4), (2, 3, 4)])


def obj(mesh, tags=()):
    points, faces = mesh
    lines = ["v " + " ".join(map(repr, p)) for p in points]
    lines += ["f " + " ".join(str(v + 1) for v in face) for face in faces]
    return "\n".join(lines + list(tags)) + "\n"


class Pages(unittest.TestCase):
    driver = None

    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.driver.set_window_size(1200, 800)

    def tearDown(self):
        self.assertEqual(self.driver.get_log("browser"), [])
        self.directory.cleanup()

    def path(self, name):
        return os.path.join(self.directory.name, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)

    def open(self, inputs, *options):
        subprocess.run([KITH, "view", *inputs, *options, "-o", self.path("page.html")], check=True,
                       stdout=subprocess.DEVNULL)
        self.driver.get("file://" + self.path("page.html"))
        self.settle()

    def settle(self):
        """Waits until the page has drawn what it was told."""
        self.driver.execute_async_script(
            "const done = arguments[0]; opened.then(() => requestAnimationFrame(() => requestAnimationFrame(done)));")

    def page(self, expression, *arguments):
        """Returns the value of an expression over `page`, the object of the page."""
        done = "arguments[arguments.length - 1]"
        return self.driver.execute_async_script(
            f"const a = arguments; opened.then(page => {{ {done}({expression}); }});", *arguments)

    def element(self, name):
        return self.driver.find_element(By.ID, name)

    def set_range(self, name, value):
        self.driver.execute_script(
            "arguments[0].value = arguments[1]; arguments[0].dispatchEvent(new Event('input', { bubbles: true }));",
            self.element(name), value)
        self.settle()

    def points(self, level, panel=0):
        flat = self.page("Array.from(page.panels[a[0]].surface.points(a[1]))", panel, level)
        return [tuple(flat[i:i + 3]) for i in range(0, len(flat), 3)]

    def refined(self, text, scheme, level):
        """Returns what the program makes of an OBJ file: points and the number of faces."""
        self.write("control.obj", text)
        subprocess.run([KITH, "refine", self.path("control.obj"), "-s", scheme, "-n", str(level), "-o",
                        self.path("fine.off")], check=True, stdout=subprocess.DEVNULL)
        with open(self.path("fine.off"), encoding="utf-8") as file:
            words = file.read().split()
        vertices, faces = int(words[1]), int(words[2])
        numbers = [float(word) for word in words[4:4 + 3 * vertices]]
        return [tuple(numbers[i:i + 3]) for i in range(0, 3 * vertices, 3)], faces

    def place(self, point, panel=0):
        """Returns the place of a point of a panel, relative to the middle of the canvas, as ActionChains takes it."""
        x, y, width, height = self.page(
            "(() => { const { window } = page.at(0, 0), [x, y] = page.camera.project(page.camera.inFrame(a[0]), window);"
            "return [x + a[1] * window.width, y, page.canvas.clientWidth, page.canvas.clientHeight]; })()",
            list(point), panel)
        return round(x - width / 2), round(y - height / 2)

    def canvas(self):
        return self.driver.find_element(By.TAG_NAME, "canvas")

    def click(self, point, panel=0):
        ActionChains(self.driver).move_to_element_with_offset(self.canvas(), *self.place(point, panel)).click().perform()
        self.settle()

    def test_slider_shows_the_levels_of_all_schemes_with_the_bits_of_the_program(self):
        for mesh, schemes, tags in ((CUBE, ("catmull-clark", "doo-sabin"), ()),
                                    (OCTAHEDRON, ("catmull-clark", "loop", "doo-sabin", "sqrt3"), ()),
                                    (OPEN, ("loop", "sqrt3", "catmull-clark"), ())):
            text = obj(mesh, tags)
            self.open([self.write("mesh.obj", text)], "-s", ",".join(schemes), "-n", "0")
            shown = [name for name in ("catmull-clark", "loop", "doo-sabin", "sqrt3") if name in schemes]
            for level in (0, 1, 2, 3, 5):
                self.set_range("level", level)
                labels = [label.text for label in self.element("labels").find_elements(By.XPATH, "./div")]
                self.assertEqual(len(labels), len(shown))
                for i, scheme in enumerate(shown):
                    points, faces = self.refined(text, scheme, level)
                    self.assertEqual(self.points(level, i), points, (scheme, level))
                    self.assertIn(scheme, labels[i])
                    self.assertIn(f"level {level}: {len(points)} vertices", labels[i])
                    self.assertIn(f"{faces} faces", labels[i])

    def test_schemes_that_need_triangles_are_not_offered_for_quads(self):
        self.open([self.write("cube.obj", obj(CUBE))])
        boxes = {box.get_attribute("value"): box for box in self.driver.find_elements(By.CSS_SELECTOR, "#schemes input")}
        self.assertEqual([name for name, box in boxes.items() if box.is_enabled()], ["catmull-clark", "doo-sabin"])
        boxes["doo-sabin"].click()
        self.settle()
        self.assertEqual(self.page("page.panels.length"), 2)
        boxes["catmull-clark"].click()
        boxes["doo-sabin"].click() # the last one stays
        self.settle()
        self.assertEqual(self.element("labels").text.split("\n")[0], "doo-sabin")

    def test_picking_shows_relatives_and_marks_descendants(self):
        self.open([self.write("cube.obj", obj(CUBE))], "-s", "catmull-clark", "-n", "3", "--view", "front")
        self.element("cage").click()
        self.click((0.5 + .02, 0, 0.5 + .02)) # a face beside the middle of the face y = 0, whose number is 2
        relatives = self.element("relatives").text
        self.assertRegex(relatives, r"face \d+ of level 3, catmull-clark")
        self.assertRegex(relatives, r"made from\s+\(v \d+, f \d+\) of level 2")
        self.assertRegex(relatives, r"parent\s+face \d+ of level 2")
        self.assertRegex(relatives, r"face 2 of level 0")
        # The control face has 4^3 quads of two triangles each; its picked vertex has one descendant.
        count = ("(() => { const { gl } = page.renderer, { triangles } = page.panels[0];"
                 "gl.bindBuffer(gl.ARRAY_BUFFER, triangles.buffers[1]);"
                 "const colors = new Uint8Array(4 * triangles.count); gl.getBufferSubData(gl.ARRAY_BUFFER, 0, colors);"
                 "let n = 0; for (let i = 0; i < colors.length; i += 4) n += colors[i] === 255 && colors[i + 1] === 165;"
                 "return n; })()")
        self.assertEqual(self.page(count), 3 * 2)
        self.page("page.select({ panel: page.panels[0], level: 0, kind: 2, number: 2 })")
        self.settle()
        self.assertEqual(self.page(count), 4**3 * 3 * 2)
        self.assertRegex(self.element("relatives").text, r"children\s+1 vertex, 4 edges, 4 faces of level 1")
        self.assertRegex(self.element("relatives").text, r"descendants\s+49 vertices, 112 edges, 64 faces of level 3")
        self.set_range("level", 1)
        self.assertEqual(self.page(count), 4 * 3 * 2)

    def test_an_element_is_picked_by_its_number(self):
        self.open([self.write("cube.obj", obj(CUBE))], "-n", "2")
        Select(self.element("kind")).select_by_visible_text("vertex")
        self.element("number").send_keys(Keys.CONTROL, "a")
        self.element("number").send_keys("7")
        self.element("pick").click()
        self.settle()
        self.assertRegex(self.element("relatives").text, r"vertex 7 of level 2(.|\n)*made from\s+\(v 7\) of level 1")
        self.assertEqual(self.element("control-name").text, "Control vertex 7")
        self.element("number").send_keys("9999")
        self.element("pick").click()
        self.assertEqual(self.element("relatives").text, "Level 2 has no vertex 79999.")

    def test_dragging_a_control_vertex_moves_the_surface(self):
        self.open([self.write("cube.obj", obj(CUBE))], "-s", "catmull-clark,doo-sabin", "-n", "3", "--view", "30,20")
        right, up = self.page("[page.camera.right, page.camera.up]")
        scale = self.page("page.camera.pixelsPerUnit(page.at(0, 0).window) / page.camera.unit")
        x, y = self.place(CUBE[0][5])
        ActionChains(self.driver, duration=20).move_to_element_with_offset(
            self.canvas(), x, y).click_and_hold().move_by_offset(30, -20).release().perform()
        self.settle()
        moved = self.points(0)
        for v, (before, after) in enumerate(zip(CUBE[0], moved)):
            expected = [b + (30 * r + 20 * u) / scale for b, r, u in zip(before, right, up)] if v == 5 else before
            for e, a in zip(expected, after):
                self.assertAlmostEqual(e, a, 9)
        for panel, scheme in enumerate(("catmull-clark", "doo-sabin")):
            self.assertEqual(self.points(3, panel), self.refined(obj((moved, CUBE[1])), scheme, 3)[0])
        # Its coordinates are typed, too.
        fields = self.element("coordinates").find_elements(By.TAG_NAME, "input")
        fields[2].send_keys(Keys.CONTROL, "a")
        fields[2].send_keys("2.25", Keys.ENTER)
        self.settle()
        moved[5] = (*moved[5][:2], 2.25)
        self.assertEqual(self.points(3), self.refined(obj((moved, CUBE[1])), "catmull-clark", 3)[0])
        self.element("reset").click()
        self.settle()
        self.assertEqual(self.points(3), self.refined(obj(CUBE), "catmull-clark", 3)[0])

    def test_sharpness_is_read_and_changed(self):
        for mesh, scheme in ((CUBE, "catmull-clark"), (OCTAHEDRON, "loop")):
            text = obj(mesh, ["t crease 2/1/0 0 2 1.5", "t corner 1/1/0 1 2.0"])
            self.open([self.write("mesh.obj", text)], "-s", scheme, "-n", "3")
            self.assertEqual(self.points(3), self.refined(text, scheme, 3)[0])
            edge = self.page("[...Array(page.cageEdges.length / 2).keys()].find(e => page.endsOf(e).join() === '0,2')")
            self.page("page.select({ panel: page.panels[0], level: 0, kind: 1, number: a[0] })", edge)
            self.settle()
            self.assertEqual(self.element("sharpness-shown").text, "1.5")
            self.set_range("sharpness", 2.5)
            self.assertEqual(self.points(3), self.refined(text.replace("1.5", "2.5"), scheme, 3)[0])
            self.element("infinite").click()
            self.settle()
            self.assertEqual(self.points(3), self.refined(text.replace("1.5", "10.0"), scheme, 3)[0])
            self.page("page.select({ panel: page.panels[0], level: 0, kind: 0, number: 1 })")
            self.settle()
            self.set_range("sharpness", 0)
            self.element("reset").click()
            self.settle()
            self.assertEqual(self.points(3), self.refined(text, scheme, 3)[0])

    def test_keys_turn_zoom_and_change_the_level(self):
        self.open([self.write("cube.obj", obj(CUBE))], "-n", "1")
        before = self.page("[page.camera.azimuth, page.camera.elevation, page.camera.shown]")
        self.canvas().send_keys(Keys.ARROW_LEFT, Keys.ARROW_DOWN, "+", Keys.PAGE_UP)
        self.settle()
        after = self.page("[page.camera.azimuth, page.camera.elevation, page.camera.shown]")
        self.assertEqual((after[0], after[1]), (before[0] + 8, before[1] + 8))
        self.assertAlmostEqual(after[2], before[2] / 1.2)
        self.assertIn("level 2: 98 vertices", self.element("labels").text)
        self.canvas().send_keys(Keys.HOME)
        self.assertEqual(self.page("[page.camera.azimuth, page.camera.elevation, page.camera.shown]"), before)

    def test_colors_and_legend(self):
        lines = ["ply", "format ascii 1.0", "element vertex 8", *(f"property double {c}" for c in "xyz"),
                 "property double heat", "element face 6", "property list uchar int vertex_indices", "property int part",
                 "end_header"]
        lines += [" ".join(map(str, [*p, p[0] + 2 * p[2]])) for p in CUBE[0]]
        lines += [" ".join(map(str, [4, *f, i])) for i, f in enumerate(CUBE[1])]
        self.open([self.write("cube.ply", "\n".join(lines) + "\n")], "--tiles", "3", "--partitioner", "block", "-n", "2")
        choice = Select(self.element("color"))
        names = [option.text for option in choice.options]
        self.assertEqual(names, ["plain", "parent: face of the control mesh", "level", "tile", "Gaussian curvature",
                                 "mean curvature", "heat", "part"])
        pictures = set()
        for name in names:
            choice.select_by_visible_text(name)
            self.settle()
            pictures.add(self.page("page.panels[0].colors.join()"))
            if name == "tile":
                self.assertEqual(self.element("legend").text.split("\n"), ["tile 0", "tile 1", "tile 2"])
            if name == "heat": # the surface lies inside the convex hull of the control mesh
                least, most = self.page("page.range")
                self.assertTrue(0 < least < 1 and 2 < most < 3)
        self.assertEqual(len(pictures), len(names))

    def test_a_page_has_many_meshes_and_any_file_name(self):
        self.open([self.write("<!--<script>.obj", obj(CUBE)), self.write("b.obj", obj(OCTAHEDRON))], "-n", "1")
        self.assertEqual([option.text for option in Select(self.element("mesh")).options], ["<!--<script>.obj", "b.obj"])
        Select(self.element("mesh")).select_by_index(1)
        self.settle()
        self.assertIn("loop", self.element("labels").text)
        self.assertEqual(self.points(1), self.refined(obj(OCTAHEDRON), "loop", 1)[0])

    def test_windows_of_all_widths_and_readers_of_screens(self):
        self.open([self.write("cube.obj", obj(CUBE))], "-s", "catmull-clark,doo-sabin")
        unnamed = self.driver.execute_script(
            "return [...document.querySelectorAll('input, select, button, canvas')].filter(e => !e.labels?.length &&"
            "!e.getAttribute('aria-label') && !e.textContent.trim()).map(e => e.outerHTML);")
        self.assertEqual(unnamed, [])
        for width, height in ((1200, 800), (500, 900)):
            self.driver.set_window_size(width, height)
            self.settle()
            view, form, inner = self.driver.execute_script(
                "const box = name => { const b = document.querySelector(name).getBoundingClientRect();"
                "return [b.left, b.top, b.right, b.bottom]; };"
                "return [box('#view'), box('form'), [innerWidth, document.documentElement.scrollWidth]];")
            self.assertEqual(inner[0], inner[1])
            self.assertTrue(view[2] <= form[0] or view[3] <= form[1])
            self.assertTrue(self.page("page.canvas.width === Math.round(page.canvas.clientWidth * devicePixelRatio)"))

    def test_an_elephant_has_four_levels(self):
        path = os.path.join(MESHES, "elephant.off")
        if not os.path.exists(path):
            self.skipTest("no elephant.off")
        self.open([path], "-s", "loop", "-n", "2", "--up", "y")
        self.assertLess(os.path.getsize(self.path("page.html")), 2e6)
        self.set_range("level", 4)
        self.assertIn(f"{5558 * 4**4} faces", self.element("labels").text)

    def test_meshes_of_any_size_and_place_are_drawn_and_picked(self):
        drawn = ("(() => { const { gl } = page.renderer, { triangles } = page.panels[0];"
                 "gl.bindBuffer(gl.ARRAY_BUFFER, triangles.buffers[0]);"
                 "const corners = new Uint8Array(16 * triangles.count); gl.getBufferSubData(gl.ARRAY_BUFFER, 0, corners);"
                 "return Array.from(corners).join(); })()")
        pictures = []
        for size, offset in ((1, 0), (2.0**20, 0), (2.0**-900, 0), (2.0**900, 0), (1, 2.0**24)):
            points = [tuple(size * x + offset for x in p) for p in CUBE[0]]
            self.open([self.write("cube.obj", obj((points, CUBE[1])))], "-n", "2", "--view", "front")
            self.element("cage").click()
            pictures.append(self.page(drawn))
            self.click(tuple(size * x + offset for x in (.52, 0, .52)))
            self.assertRegex(self.element("relatives").text, r"face \d+ of level 2(.|\n)*face 2 of level 0")
        self.assertEqual(len(set(pictures)), 1)

    def test_memory_does_not_grow(self):
        self.open([self.write("a.obj", obj(OCTAHEDRON)), self.write("b.obj", obj(CUBE))], "-n", "0")
        sizes = []
        for _ in range(3):
            for mesh in (0, 1):
                Select(self.element("mesh")).select_by_index(mesh)
                for level in (6, 0, 3):
                    self.set_range("level", level)
                self.page("page.moveVertex(0, [2, -1, 3])")
                self.settle()
            sizes.append(self.page("page.library.call.memory.buffer.byteLength"))
        self.assertEqual(sizes[1], sizes[2])

    def test_a_lost_context_comes_back(self):
        self.open([self.write("cube.obj", obj(CUBE))], "-n", "2")
        self.page("void (page.lost = page.renderer.gl.getExtension('WEBGL_lose_context'))")
        self.driver.execute_async_script(
            "const done = arguments[0]; opened.then(page => {"
            "page.canvas.addEventListener('webglcontextrestored', () => setTimeout(done));"
            "page.lost.loseContext(); setTimeout(() => page.lost.restoreContext(), 100); });")
        self.settle()
        self.assertTrue(self.page("page.renderer.gl.isBuffer(page.panels[0].triangles.buffers[0])"))
        self.assertFalse(self.element("failure").is_displayed())

    def test_moving_drops_the_levels_that_are_not_shown(self):
        self.open([self.write("cube.obj", obj(CUBE))], "-s", "catmull-clark", "-n", "4")
        self.set_range("level", 1)
        self.page("page.moveVertex(5, [2, -1, 3])")
        self.settle()
        moved = [*CUBE[0][:5], (2, -1, 3), *CUBE[0][6:]]
        for level in (1, 4):
            self.set_range("level", level)
            self.assertEqual(self.points(level), self.refined(obj((moved, CUBE[1])), "catmull-clark", level)[0])

    def test_bad_input_is_refused(self):
        for text, options, code, message in (
                (obj((CUBE[0], [*CUBE[1], (0, 1, 3)])), [], 1, "face"),
                (obj(CUBE), ["-s", "butterfly"], 2, "is no scheme of the page; those are catmull-clark, loop"),
                (obj(CUBE), ["-n", "-1"], 2, "ask for 0 or more"),
                (obj(CUBE), ["-s", "loop"], 1, "--triangulate"),
                (obj(CUBE), ["--partitioner", "block"], 2, "name --tiles as well")):
            run = subprocess.run([KITH, "view", self.write("mesh.obj", text), "-o", self.path("none.html"), *options],
                                 capture_output=True, text=True, check=False)
            self.assertEqual(run.returncode, code, run.stderr)
            self.assertIn(message, run.stderr)
            self.assertFalse(os.path.exists(self.path("none.html")))
        run = subprocess.run([KITH, "view", self.write("mesh.obj", obj(CUBE)), "-o", "-"], capture_output=True, text=True,
                             check=False)
        self.assertEqual(run.returncode, 2)
        self.assertIn("give one that ends with .html", run.stderr)


def start_chromium():
    options = webdriver.ChromeOptions()
    options.binary_location = "/usr/bin/chromium"
    for argument in ("--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                     "--disable-dev-shm-usage", "--window-size=1200,800"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)


try:
    Pages.driver = start_chromium()
except WebDriverException as error:
    print("skipped: Chromium does not start:", error.msg)
    sys.exit(77)
Pages.driver.set_script_timeout(60)
try:
    unittest.main(argv=sys.argv[:1], verbosity=2)
finally:
    Pages.driver.quit()
