// The library in this page: surfaces with all their levels, refined by the code of kith that runs elsewhere, too.

const kinds = ["vertex", "edge", "face"];
const schemes = ["catmull-clark", "loop", "doo-sabin", "sqrt3"];
const colorings = { plain: 0, parent: 1, faceNumber: 2, faceValue: 3, vertexValue: 4, gaussian: 5, mean: 6, level: 7 };
const palettes = { numbers: 0, shares: 1, signs: 2 };

/** The functions of module.cpp and the memory in which their arrays lie. */
class Library {
    static async load(base64) {
        const bytes = Uint8Array.from(atob(base64), c => c.charCodeAt(0));
        const library = new Library();
        const nothing = () => 0; // no files
        const { instance } = await WebAssembly.instantiate(bytes, {
            env: { fail: text => { throw new Error(library.text(text)); } },
            wasi_snapshot_preview1: { fd_close: nothing, fd_seek: nothing, fd_write: nothing },
        });
        library.call = instance.exports;
        library.call._initialize();
        return library;
    }

    text(pointer) {
        const bytes = new Uint8Array(this.call.memory.buffer, pointer);
        return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
    }

    /** Returns a copy of an array that a function returned, with `width` numbers for each of its elements. */
    array(Type, pointer, width = 1) {
        const [data, size] = new Uint32Array(this.call.memory.buffer, pointer, 2);
        return new Type(this.call.memory.buffer, data, size * width).slice();
    }

    /** Calls function(pointers) with copies of arrays in the library's memory, which it frees afterwards. */
    withArrays(arrays, callback) {
        const pointers = arrays.map(values => {
            const pointer = this.call.allocate(Math.max(values.byteLength, 8));
            new values.constructor(this.call.memory.buffer, pointer, values.length).set(values);
            return pointer;
        });
        const result = callback(...pointers);
        pointers.forEach(pointer => this.call.release(pointer));
        return result;
    }

    color(value, palette, [least, most]) {
        return this.array(Uint8Array, this.call.color_of(value, palette, least, most), 4);
    }
}

/**
 * A control mesh with a scheme and the levels that were asked for, drawn in the frame of a camera. Elements are objects
 * { level, kind, number }.
 */
class Surface {
    constructor(library, scheme, control, { origin, unit }) {
        this.library = library;
        this.scheme = scheme;
        this.handle = library.withArrays([control.points, control.degrees, control.corners], (points, degrees, corners) =>
            library.call.open_surface(scheme, control.points.length / 3, points, control.degrees.length, degrees, corners));
        library.call.set_frame(this.handle, ...origin, unit);
        this.sharpen(control);
    }

    close() { this.library.call.close_surface(this.handle); }

    sharpen({ sharpEdges, sharpVertices, isChaikin }) {
        const edges = [...sharpEdges.values()], vertices = [...sharpVertices];
        this.library.withArrays(
            [Uint32Array.from(edges.flatMap(e => e.ends)), Float64Array.from(edges, e => e.sharpness),
             Uint32Array.from(vertices, v => v[0]), Float64Array.from(vertices, v => v[1])],
            (ends, ofEdges, numbers, ofVertices) => this.library.call.sharpen(
                this.handle, edges.length, ends, ofEdges, vertices.length, numbers, ofVertices, isChaikin));
    }
    /** Moves the control mesh and the levels up to `last`. */
    move(points, last) {
        this.library.withArrays([points], pointer => this.library.call.move_points(this.handle, pointer, last));
    }
    levelsWithin(faces) { return this.library.call.levels_within(this.handle, faces); }
    refineTo(level) { this.library.call.refine_to(this.handle, level); }

    counts(level) { return this.array(Uint32Array, "counts", level); }
    points(level) { return this.array(Float64Array, "points", level); }
    edges(level) { return this.array(Uint32Array, "edges", level); }
    edgeEnds(level) { return this.arrayOf(3, Float32Array, "edge_ends", level); }
    faceVertices(level, face) { return this.array(Uint32Array, "face_vertices", level, face); }
    faceEdges(level, face) { return this.array(Uint32Array, "face_edges", level, face); }
    /** Returns 16 bytes for each corner of the triangles: three floats, and three bytes of the normal. */
    triangles(level, isSmooth) { return this.arrayOf(16, Uint8Array, "triangles", level, isSmooth); }
    firstTriangles(level) { return this.array(Uint32Array, "first_triangles", level); }

    /** Sets the values that give the colors, and returns their range, or an empty array. */
    setValues(level, coloring, values) {
        return this.library.withArrays([values], pointer =>
            this.array(Float64Array, "set_values", level, coloring, values.length, pointer));
    }
    colors(level, palette, [least, most]) { return this.arrayOf(4, Uint8Array, "colors", level, palette, least, most); }

    /** Returns the elements of the level before whose tuple made an element. */
    origin({ level, kind, number }) {
        const listed = this.array(Uint32Array, "origin", level, kind, number);
        return Array.from({ length: listed.length / 2 },
                          (_, i) => ({ level: level - 1, kind: listed[2 * i], number: listed[2 * i + 1] }));
    }
    ancestor({ level, kind, number }, coarser) {
        const [kindThere, numberThere] = this.array(Uint32Array, "ancestor", level, kind, number, coarser);
        return { level: coarser, kind: kindThere, number: numberThere };
    }
    /** Returns the numbers of the descendants of one kind as a list of [begin, end]. */
    descendants({ level, kind, number }, finer, kindThere) {
        const ends = this.array(Uint32Array, "descendants", level, kind, number, finer, kindThere);
        return Array.from({ length: ends.length / 2 }, (_, i) => [ends[2 * i], ends[2 * i + 1]]);
    }
    /** Returns the face that a ray of the frame meets first, or undefined. */
    faceAt(level, from, direction) { return this.array(Uint32Array, "face_at", level, ...from, ...direction)[0]; }

    array(Type, name, ...given) { return this.arrayOf(1, Type, name, ...given); }
    arrayOf(width, Type, name, ...given) {
        return this.library.array(Type, this.library.call[name](this.handle, ...given), width);
    }
}
