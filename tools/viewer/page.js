// The page: what its controls do, and the elements under the pointer.

const mostFaces = 1.5e6; // of all panels together: what browsers refine and draw at once
const cageInk = [.55, .15, .1, 1], sharpInk = [.85, .1, .1, 1], wireInk = [.15, .15, .18, .55], pickInk = [.95, .45, 0, 1];
const pickColor = [255, 165, 60, 255];
const $ = id => document.getElementById(id);

/** Returns a control mesh of the page's content, with typed arrays; null stands for infinity there. */
function controlMesh(given) {
    const sharpness = x => x ?? Infinity;
    const key = (a, b) => Math.min(a, b) + "," + Math.max(a, b);
    return {
        points: Float64Array.from(given.points),
        degrees: Uint32Array.from(given.degrees),
        corners: Uint32Array.from(given.corners),
        sharpEdges: new Map(given.edges.map(([a, b, s]) => [key(a, b), { ends: [a, b], sharpness: sharpness(s) }])),
        sharpVertices: new Map(given.vertices.map(([v, s]) => [v, sharpness(s)])),
        isChaikin: given.chaikin,
    };
}

class Page {
    constructor(library, content) {
        this.library = library;
        this.content = content;
        this.renderer = new Renderer(document.querySelector("canvas"));
        this.canvas = this.renderer.gl.canvas;
        this.camera = new Camera(content.view);
        this.panels = [];
        this.fillControls();
        this.listen();
        this.openMesh(0);
    }

    // What is shown

    /** Opens a mesh of the gallery, with the schemes that take it. */
    openMesh(index) {
        this.given = this.content.meshes[index];
        this.control = controlMesh(this.given);
        this.camera.measure(this.control.points);
        const onlyTriangles = this.control.degrees.every(degree => degree === 3);
        this.schemeBoxes.forEach((box, scheme) => {
            box.disabled = !onlyTriangles && (scheme === 1 || scheme === 3);
            box.parentNode.title = box.disabled ? "This scheme takes triangles only." : "";
            box.checked = !box.disabled && this.content.schemes.includes(schemes[scheme]);
        });
        if (!this.schemeBoxes.some(box => box.checked))
            this.schemeBoxes[onlyTriangles ? 1 : 0].checked = true;
        $("cage").checked = this.control.degrees.length <= 500;
        this.fillColors();
        this.openPanels();
        document.title = this.given.name + " - kith";
    }

    /** Makes a panel for each scheme that is chosen. */
    openPanels() {
        const chosen = this.schemeBoxes.flatMap((box, scheme) => box.checked ? [scheme] : []);
        const opened = chosen.map(scheme =>
            ({ scheme, surface: new Surface(this.library, scheme, this.control, this.camera) }));
        this.panels.forEach(panel => { this.free(panel); panel.surface.close(); });
        this.panels = opened;
        const within = this.panels.map(panel => panel.surface.levelsWithin(Math.floor(mostFaces / chosen.length)));
        $("level").max = Math.min(...within);
        if ($("level").dataset.set === undefined)
            $("level").value = this.content.level;
        $("level").dataset.set = "";
        $("labels").replaceChildren(...this.panels.map(panel => panel.label = document.createElement("div")));
        this.selected = undefined;
        this.showLevel();
    }

    get level() { return Number($("level").value); }

    showLevel() {
        $("level-shown").value = this.level;
        for (const panel of this.panels) {
            panel.surface.refineTo(this.level);
            const [v, e, f] = panel.surface.counts(this.level);
            const name = document.createElement("b"), counted = document.createElement("small");
            name.textContent = schemes[panel.scheme];
            counted.textContent = `level ${this.level}: ${v} vertices, ${e} edges, ${f} faces`;
            panel.label.replaceChildren(name, counted);
        }
        const counts = this.panels[0].surface.counts(this.level);
        $("number").max = counts[kinds.indexOf($("kind").value)] - 1;
        this.canvas.setAttribute("aria-label", "Surfaces: " + this.panels.map(p => p.label.innerText).join("; "));
        this.makeSurfaces();
    }

    /** Makes what is drawn of the surfaces, after a change of the level or of the control mesh. */
    makeSurfaces() {
        const coloring = this.colorings[$("color").selectedIndex];
        const ranges = this.panels.map(({ surface }) => surface.setValues(this.level, coloring.by, coloring.values));
        const found = ranges.filter(range => range.length === 2);
        this.range = found.length === 0 ? [0, 1]
            : [Math.min(...found.map(range => range[0])), Math.max(...found.map(range => range[1]))];
        for (const panel of this.panels) {
            this.free(panel);
            panel.colors = panel.surface.colors(this.level, coloring.palette, this.range);
            panel.triangles = this.renderer.makeTriangles(panel.surface.triangles(this.level, $("smooth").checked),
                                                          panel.colors);
            panel.ends = panel.surface.edgeEnds(this.level);
            panel.wire = this.renderer.makeLines(panel.ends);
        }
        this.showLegend(coloring);
        this.makeCage();
        this.showSelected();
    }

    makeCage() {
        const { surface } = this.panels[0];
        this.cageEdges = surface.edges(0);
        const line = (a, b) => [...this.controlPoint(a), ...this.controlPoint(b)];
        const sharp = [...this.control.sharpEdges.values()].flatMap(e => e.sharpness > 0 ? line(...e.ends) : []);
        const sharpDots = [...this.control.sharpVertices].flatMap(([v, s]) => s > 0 ? line(v, v) : []);
        const dots = Array.from({ length: this.control.points.length / 3 }, (_, v) => line(v, v)).flat();
        (this.cage ?? []).forEach(({ made }) => this.renderer.free(made));
        const lines = (ends, width, ink, lift) =>
            ({ made: this.renderer.makeLines(Float32Array.from(ends)), width, ink, lift });
        this.cage = [lines(surface.edgeEnds(0), 1.4, cageInk, .001), lines(dots, 6, cageInk, .001),
                     lines(sharp, 3, sharpInk, .0015), lines(sharpDots, 9, sharpInk, .0015)];
    }

    free(panel) {
        for (const part of ["triangles", "wire", "marks"]) {
            this.renderer.free(panel[part]);
            panel[part] = undefined;
        }
    }

    draw() {
        if (this.isDrawing)
            return;
        this.isDrawing = true;
        requestAnimationFrame(() => {
            this.isDrawing = false;
            this.renderer.fit(devicePixelRatio);
            this.renderer.draw(this.camera, this.panels.map(panel => ({
                triangles: panel.triangles,
                lines: [...($("wire").checked ? [{ made: panel.wire, width: 1, ink: wireInk, lift: .0004 }] : []),
                        ...($("cage").checked ? this.cage : []),
                        ...(panel.marks ? [{ made: panel.marks, width: panel.markWidth, ink: pickInk, lift: .002 }] : [])],
            })), devicePixelRatio);
        });
    }

    showLegend({ palette, labels }) {
        const css = value => `rgb(${this.library.color(value, palette, this.range).slice(0, 3).join()})`;
        const element = (name, properties, ...children) => {
            const made = Object.assign(document.createElement(name), properties);
            made.append(...children);
            return made;
        };
        if (palette === palettes.numbers) {
            const entry = i => {
                const square = element("i");
                square.style.background = css(i);
                return element("div", {}, square, labels[i]);
            };
            const shown = [...(labels ?? []).keys()].filter(i => i >= this.range[0] && i <= this.range[1]);
            $("legend").replaceChildren(...shown.slice(0, 12).map(entry), ...shown.length > 12 ? ["..."] : []);
            return;
        }
        const [least, most] = this.range, steps = [0, .25, .5, .75, 1].map(share => least + share * (most - least));
        const bar = element("div", { className: "bar" });
        bar.style.background = `linear-gradient(to top, ${steps.map(css).join()})`;
        const rounded = digits => steps.map(x => Number(x.toPrecision(digits)));
        let digits = 3;
        while (digits < 15 && new Set(rounded(digits)).size < steps.length)
            ++digits; // so that all are different
        const ticks = rounded(digits).reverse().map(x => element("span", { textContent: x }));
        $("legend").replaceChildren(element("div", { className: "scale" }, bar,
                                            element("div", { className: "ticks" }, ...ticks)));
    }

    // The selected element: { panel, level, kind, number }

    select(element) {
        this.selected = element;
        this.showSelected();
    }

    showSelected() {
        for (const panel of this.panels) {
            this.renderer.free(panel.marks);
            panel.marks = undefined;
            if (panel.isMarked)
                this.renderer.setColors(panel.triangles, panel.colors);
            panel.isMarked = false;
        }
        if (this.selected)
            this.mark(this.selected.panel, this.selected);
        this.showRelatives();
        this.showControl();
        this.draw();
    }

    /** Marks the descendants of an element on the level that is shown, or its ancestor there. */
    mark(panel, element) {
        const { surface } = panel;
        const origin = element.level <= this.level ? element : surface.ancestor(element, this.level);
        const descendants = [0, 1, 2].map(kind => surface.descendants(origin, this.level, kind));
        if (descendants[2].length > 0) {
            const first = surface.firstTriangles(this.level), colors = panel.colors.slice();
            for (const [begin, end] of descendants[2])
                for (let i = 12 * first[begin]; i < 12 * first[end]; i += 4)
                    colors.set(pickColor, i);
            this.renderer.setColors(panel.triangles, colors);
            panel.isMarked = true;
        }
        const ends = [];
        for (const [begin, end] of descendants[1])
            for (const x of panel.ends.subarray(6 * begin, 6 * end))
                ends.push(x);
        if (origin.kind === 0) {
            const points = surface.points(this.level);
            for (const [begin, end] of descendants[0])
                for (let v = begin; v < end; ++v)
                    ends.push(...this.pointOf(points, v), ...this.pointOf(points, v));
        }
        panel.markWidth = origin.kind === 0 ? 9 : origin.kind === 1 ? 4 : 1.5;
        panel.marks = this.renderer.makeLines(Float32Array.from(ends));
    }

    showRelatives() {
        if (!this.selected) {
            $("relatives").textContent = "Click an element, or type its number.";
            return;
        }
        const { panel: { surface, scheme }, level, kind, number } = this.selected;
        const rows = [["element", `${kinds[kind]} ${number} of level ${level}, ${schemes[scheme]}`]];
        if (level > 0) {
            const tuple = surface.origin(this.selected).map(x => kinds[x.kind][0] + " " + x.number);
            rows.push(["made from", `(${tuple.join(", ")}) of level ${level - 1}`]);
            const ancestors = [];
            for (let coarser = level - 1; coarser >= 0; --coarser) {
                const found = surface.ancestor(this.selected, coarser);
                ancestors.push(`${kinds[found.kind]} ${found.number} of level ${coarser}`);
            }
            rows.push(["parent", ancestors[0]]);
            if (level > 1)
                rows.push(["ancestors", ancestors.slice(1).join(", ")]);
        }
        if (level < this.level) {
            const count = (finer, kindThere) =>
                surface.descendants(this.selected, finer, kindThere).reduce((sum, [begin, end]) => sum + end - begin, 0);
            const counted = finer => [0, 1, 2].flatMap(kindThere => {
                const n = count(finer, kindThere), noun = kinds[kindThere];
                return n === 0 ? [] : [`${n} ${n === 1 ? noun : noun === "vertex" ? "vertices" : noun + "s"}`];
            }).join(", ");
            rows.push(["children", `${counted(level + 1)} of level ${level + 1}`]);
            if (level + 1 < this.level)
                rows.push(["descendants", `${counted(this.level)} of level ${this.level}`]);
        }
        const list = document.createElement("dl");
        for (const [term, text] of rows)
            for (const [name, content] of [["dt", term], ["dd", text]])
                list.appendChild(document.createElement(name)).textContent = content;
        $("relatives").replaceChildren(list);
    }

    // The control mesh

    /** Returns the element of the control mesh from which the selected one descends. */
    get controlElement() { return this.selected && this.selected.panel.surface.ancestor(this.selected, 0); }

    showControl() {
        const element = this.controlElement;
        $("control").hidden = !element || element.kind === 2;
        if ($("control").hidden)
            return;
        $("control-name").textContent = `Control ${kinds[element.kind]} ${element.number}`;
        const takesCreases = this.panels.some(panel => panel.scheme < 2);
        for (const row of ["sharpness-row", "infinite-row"])
            $(row).hidden = !takesCreases;
        const sharpness = this.sharpnessOf(element), isInfinite = sharpness === Infinity;
        $("sharpness").value = isInfinite ? 5 : sharpness;
        $("sharpness").disabled = isInfinite;
        $("sharpness-shown").value = isInfinite ? "infinite" : sharpness;
        $("infinite").checked = isInfinite;
        $("coordinates").hidden = element.kind !== 0;
        if (element.kind === 0)
            this.coordinateInputs.forEach((input, i) => { input.value = this.control.points[3 * element.number + i]; });
    }

    endsOf(edge) { return [...this.cageEdges.subarray(2 * edge, 2 * edge + 2)].sort((a, b) => a - b); }
    sharpnessOf({ kind, number }) {
        return kind === 0 ? this.control.sharpVertices.get(number) ?? 0
                          : this.control.sharpEdges.get(this.endsOf(number).join())?.sharpness ?? 0;
    }
    setSharpness(sharpness) {
        const { kind, number } = this.controlElement;
        if (kind === 0)
            this.control.sharpVertices.set(number, sharpness);
        else
            this.control.sharpEdges.set(this.endsOf(number).join(), { ends: this.endsOf(number), sharpness });
        this.later(() => {
            this.sharpen();
            this.makeSurfaces();
        });
    }
    moveVertex(vertex, point) {
        if (!point.every(Number.isFinite))
            return;
        this.control.points.set(point, 3 * vertex);
        this.camera.include(point);
        this.later(() => {
            this.panels.forEach(panel => panel.surface.move(this.control.points, this.level));
            this.makeSurfaces();
        });
    }
    reset() {
        this.control = controlMesh(this.given);
        this.panels.forEach(panel => panel.surface.move(this.control.points, 0));
        this.sharpen();
        this.makeSurfaces();
    }
    sharpen() {
        for (const { surface } of this.panels) {
            surface.sharpen(this.control);
            surface.refineTo(this.level);
        }
    }
    /** Calls the last of the functions that are given before the next picture. */
    later(callback) {
        if (!this.waiting)
            requestAnimationFrame(() => {
                const last = this.waiting;
                this.waiting = undefined;
                this.guard(last);
            });
        this.waiting = callback;
    }

    // Pointer and keys

    /** Returns the panel under a place of the canvas, the place in it, and its size. */
    at(x, y) {
        const window = { width: this.canvas.clientWidth / this.panels.length, height: this.canvas.clientHeight };
        const i = Math.min(Math.max(Math.floor(x / window.width), 0), this.panels.length - 1);
        return { panel: this.panels[i], x: x - i * window.width, y, window };
    }

    distanceToPoint(point, { x, y, window }) {
        const [px, py] = this.camera.project(point, window);
        return Math.hypot(px - x, py - y);
    }
    distanceToEdge(a, b, { x, y, window }) {
        const [ax, ay] = this.camera.project(a, window), [bx, by] = this.camera.project(b, window);
        const length = (bx - ax) ** 2 + (by - ay) ** 2;
        const t = length > 0 ? Math.min(Math.max(((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / length, 0), 1) : 0;
        return Math.hypot(ax + t * (bx - ax) - x, ay + t * (by - ay) - y);
    }
    /** Returns a point of an array in the frame of the camera. */
    pointOf(points, v) { return this.camera.inFrame([...points.subarray(3 * v, 3 * v + 3)]); }
    controlPoint(v) { return this.pointOf(this.control.points, v); }

    /** Returns the number of the vertex of the control mesh near a place; among several the one nearest to the viewer. */
    controlVertexAt(place) {
        let found, nearest = -Infinity;
        for (let v = 0; 3 * v < this.control.points.length; ++v) {
            const point = this.controlPoint(v), depth = this.camera.project(point, place.window)[2];
            if (depth > nearest && this.distanceToPoint(point, place) < 9)
                [found, nearest] = [v, depth];
        }
        return found;
    }
    controlEdgeAt(place) {
        let found, nearest = -Infinity;
        for (let e = 0; 2 * e < this.cageEdges.length; ++e) {
            const [a, b] = this.endsOf(e).map(v => this.controlPoint(v));
            const depth = this.camera.project(times(add(a, b), .5), place.window)[2];
            if (depth > nearest && this.distanceToEdge(a, b, place) < 5)
                [found, nearest] = [e, depth];
        }
        return found;
    }

    /** Returns the element under a place: of the control mesh if it is shown, else of the level. */
    elementAt(place) {
        const { panel, x, y, window } = place, { surface } = panel;
        if ($("cage").checked) {
            const vertex = this.controlVertexAt(place), edge = vertex ?? this.controlEdgeAt(place);
            if (edge !== undefined)
                return { panel, level: 0, kind: vertex !== undefined ? 0 : 1, number: edge };
        }
        const face = surface.faceAt(this.level, ...this.camera.ray(x, y, window));
        if (face === undefined)
            return undefined;
        const points = surface.points(this.level);
        for (const number of surface.faceVertices(this.level, face))
            if (this.distanceToPoint(this.pointOf(points, number), place) < 6)
                return { panel, level: this.level, kind: 0, number };
        for (const number of surface.faceEdges(this.level, face)) {
            const ends = panel.ends.subarray(6 * number, 6 * number + 6);
            if (this.distanceToEdge([...ends.subarray(0, 3)], [...ends.subarray(3)], place) < 4)
                return { panel, level: this.level, kind: 1, number };
        }
        return { panel, level: this.level, kind: 2, number: face };
    }

    listenToPointers() {
        const pointers = new Map(), place = event => this.at(event.offsetX, event.offsetY);
        let dragged, moved;
        this.canvas.addEventListener("pointerdown", event => {
            this.canvas.setPointerCapture(event.pointerId);
            pointers.set(event.pointerId, event);
            moved = pointers.size === 1 && event.button === 0 ? 0 : Infinity; // then it is no click
            dragged = $("cage").checked && moved === 0 && !event.shiftKey ? this.controlVertexAt(place(event))
                                                                                 : undefined;
            if (dragged !== undefined)
                this.select({ panel: place(event).panel, level: 0, kind: 0, number: dragged });
        });
        this.canvas.addEventListener("pointermove", event => {
            const before = pointers.get(event.pointerId);
            if (!before)
                return;
            const x = event.offsetX - before.offsetX, y = event.offsetY - before.offsetY;
            const { window } = place(event);
            moved += Math.abs(x) + Math.abs(y);
            if (pointers.size === 2) {
                const other = [...pointers.values()].find(p => p.pointerId !== event.pointerId);
                const distance = p => Math.hypot(p.offsetX - other.offsetX, p.offsetY - other.offsetY);
                this.camera.zoom(distance(event) / Math.max(distance(before), 1));
                this.camera.pan(x / 2, y / 2, window);
            } else if (dragged !== undefined) {
                const point = this.control.points.subarray(3 * dragged, 3 * dragged + 3);
                this.moveVertex(dragged, this.camera.moved([...point], x, y, window));
            } else if (event.shiftKey || event.buttons === 4) {
                this.camera.pan(x, y, window);
            } else {
                this.camera.orbit(x, y);
            }
            pointers.set(event.pointerId, event);
            this.draw();
        });
        const end = event => {
            const isClick = pointers.delete(event.pointerId) && event.type === "pointerup" && moved < 4;
            if (isClick && dragged === undefined)
                this.guard(() => this.select(this.elementAt(place(event))));
        };
        this.canvas.addEventListener("pointerup", end);
        this.canvas.addEventListener("pointercancel", end);
        this.canvas.addEventListener("wheel", event => {
            event.preventDefault();
            this.camera.zoom(Math.exp(-event.deltaY * .001));
            this.draw();
        }, { passive: false });
    }

    listenToKeys() {
        const directions = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
        this.canvas.addEventListener("keydown", event => {
            const { window } = this.at(0, 0), direction = directions[event.key];
            if (direction && event.shiftKey)
                this.camera.pan(...times(direction, 24), window);
            else if (direction)
                this.camera.orbit(...times(direction, 20));
            else if (event.key === "+" || event.key === "=")
                this.camera.zoom(1.2);
            else if (event.key === "-")
                this.camera.zoom(1 / 1.2);
            else if (event.key === "Home")
                this.camera.goHome();
            else if (event.key === "PageUp" || event.key === "PageDown") {
                $("level").value = this.level + (event.key === "PageUp" ? 1 : -1);
                this.guard(() => this.showLevel());
            } else
                return;
            event.preventDefault();
            this.draw();
        });
    }

    // Controls

    fillControls() {
        const option = text => new Option(text);
        $("mesh").replaceChildren(...this.content.meshes.map(mesh => option(mesh.name)));
        $("mesh-row").hidden = this.content.meshes.length === 1;
        this.schemeBoxes = schemes.map(name => {
            const label = $("schemes").appendChild(document.createElement("label"));
            const box = label.appendChild(Object.assign(document.createElement("input"), { type: "checkbox", value: name }));
            label.append(" " + name);
            return box;
        });
        this.coordinateInputs = [...$("coordinates").children];
    }

    fillColors() {
        const none = new Float64Array(), { numbers, shares, signs } = palettes;
        const coloring = (name, by, palette, values = none, labels = undefined) => ({ name, by, palette, values, labels });
        const values = list => Float64Array.from(list, x => x ?? NaN);
        this.colorings = [
            coloring("plain", colorings.plain, numbers),
            coloring("parent: face of the control mesh", colorings.parent, numbers),
            coloring("level", colorings.level, numbers, none,
                     Array.from({ length: 21 }, (_, level) => "level " + level)),
            ...this.given.tiles.length === 0 ? []
                : [coloring("tile", colorings.faceNumber, numbers, values(this.given.tiles),
                            Array.from({ length: this.given.tileCount }, (_, tile) => "tile " + tile))],
            coloring("Gaussian curvature", colorings.gaussian, signs),
            coloring("mean curvature", colorings.mean, signs),
            ...this.given.attributes.map(a => a.labels.length > 0
                ? coloring(a.name, colorings.faceNumber, numbers, values(a.values), a.labels)
                : coloring(a.name, a.on === "vertices" ? colorings.vertexValue : colorings.faceValue, shares,
                           values(a.values))),
        ];
        $("color").replaceChildren(...this.colorings.map(c => new Option(c.name)));
    }

    listen() {
        const on = (id, type, callback) => $(id).addEventListener(type, () => this.guard(callback));
        on("mesh", "change", () => this.openMesh($("mesh").selectedIndex));
        this.schemeBoxes.forEach(box => box.addEventListener("change", () => this.guard(() => {
            if (!this.schemeBoxes.some(other => other.checked))
                box.checked = true; // one scheme at least is shown
            this.openPanels();
        })));
        on("level", "input", () => this.showLevel());
        on("color", "change", () => this.makeSurfaces());
        on("smooth", "change", () => this.makeSurfaces());
        on("wire", "change", () => this.draw());
        on("cage", "change", () => this.draw());
        on("kind", "change", () => this.showLevel());
        on("pick", "click", () => {
            const kind = kinds.indexOf($("kind").value), number = Number($("number").value), [panel] = this.panels;
            if (Number.isInteger(number) && number >= 0 && number < panel.surface.counts(this.level)[kind])
                this.select({ panel, level: this.level, kind, number });
            else
                $("relatives").textContent = `Level ${this.level} has no ${kinds[kind]} ${$("number").value}.`;
        });
        on("sharpness", "input", () => this.setSharpness(Number($("sharpness").value)));
        on("infinite", "change", () => this.setSharpness($("infinite").checked ? Infinity : Number($("sharpness").value)));
        this.coordinateInputs.forEach(input => input.addEventListener("change", () => this.guard(() => {
            if (this.coordinateInputs.every(given => given.value !== ""))
                this.moveVertex(this.controlElement.number, this.coordinateInputs.map(given => Number(given.value)));
        })));
        on("reset", "click", () => this.reset());
        this.listenToPointers();
        this.listenToKeys();
        new ResizeObserver(() => this.draw()).observe(this.canvas);
        this.canvas.addEventListener("webglcontextlost", event => event.preventDefault()); // so that it comes back
        this.canvas.addEventListener("webglcontextrestored", () => this.guard(() => {
            for (const panel of this.panels) // their buffers are gone
                panel.triangles = panel.wire = panel.marks = undefined;
            this.cage = undefined;
            this.renderer.start();
            this.makeSurfaces();
        }));
    }

    /** Calls a function, and shows its error to the reader. */
    guard(callback) {
        try {
            callback();
        } catch (error) {
            showFailure(error);
        }
    }
}

function showFailure(error) {
    $("failure").textContent = error.message + " Load the page again to go on.";
    $("failure").hidden = false;
}

const text = id => $(id).textContent;
const opened = Library.load(text("library")).then(library => new Page(library, JSON.parse(text("content"))));
opened.catch(showFailure);
