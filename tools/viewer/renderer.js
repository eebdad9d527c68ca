// Draws triangles and lines by WebGL 2.

const viewOfVertex = `
    uniform vec3 right, up, toward, center;
    uniform vec2 scale;  // from the units of the frame to those of the window
    uniform float depth; // of the scene, in front of the center and behind it
    vec4 placed(vec3 p) {
        p -= center;
        return vec4(dot(p, right) * scale.x, dot(p, up) * scale.y, -dot(p, toward) / depth, 1);
    }`;

const surfaceShaders = [`#version 300 es
    ${viewOfVertex}
    layout(location = 0) in vec3 position;
    layout(location = 1) in vec3 normal;
    layout(location = 2) in vec4 color;
    out vec3 turned;
    out vec4 paint;
    void main() {
        gl_Position = placed(position);
        turned = vec3(dot(normal, right), dot(normal, up), dot(normal, toward));
        paint = color;
    }`, `#version 300 es
    precision highp float;
    in vec3 turned;
    in vec4 paint;
    out vec4 pixel;
    void main() {
        vec3 n = normalize(turned);
        if (n.z < 0.)
            n = -n; // a side that is seen from behind
        float light = max(dot(n, normalize(vec3(-.35, .5, .8))), 0.);
        pixel = vec4(paint.rgb * (.45 + .6 * light), 1);
    }`];

// A line is a rectangle with round ends, which makes points of lines between equal ends.
const lineShaders = [`#version 300 es
    ${viewOfVertex}
    uniform vec2 pixels;
    uniform float width, lift;
    layout(location = 0) in vec3 begin;
    layout(location = 1) in vec3 end;
    out vec3 along; // in pixels: along the line, across it, and its length
    void main() {
        vec4 a = placed(begin), b = placed(end);
        vec2 across = (b.xy - a.xy) * pixels / 2.;
        float size = length(across);
        vec2 t = size > 1e-3 ? across / size : vec2(1, 0), n = vec2(-t.y, t.x);
        bool isEnd = (gl_VertexID & 1) == 1;
        float forward = isEnd ? 1. : -1., side = (gl_VertexID & 2) == 2 ? 1. : -1., reach = width / 2. + 1.;
        vec4 at = isEnd ? b : a;
        at.xy += (t * forward + n * side) * reach * 2. / pixels;
        at.z += (size > 1e-3 ? (b.z - a.z) * forward * reach / size : 0.) - lift;
        gl_Position = at;
        along = vec3(isEnd ? size + reach : -reach, side * reach, size);
    }`, `#version 300 es
    precision highp float;
    uniform vec4 ink;
    uniform float width;
    in vec3 along;
    out vec4 pixel;
    void main() {
        float distance = length(vec2(along.x - clamp(along.x, 0., along.z), along.y));
        float share = clamp(width / 2. + .5 - distance, 0., 1.);
        if (share == 0.)
            discard;
        pixel = vec4(ink.rgb, ink.a * share);
    }`];

class Renderer {
    constructor(canvas) {
        this.gl = canvas.getContext("webgl2", { antialias: true, alpha: false });
        if (!this.gl)
            throw new Error("This browser has no WebGL 2, which this page needs.");
        this.start();
    }

    /** Compiles the programs, at first and after the browser has lost them. */
    start() { this.programs = { surface: this.program(surfaceShaders), lines: this.program(lineShaders) }; }

    /** Gives the canvas as many pixels as it has on the screen. */
    fit(density) {
        const { canvas } = this.gl, pixels = size => Math.max(Math.round(size * density), 1);
        const [width, height] = [pixels(canvas.clientWidth), pixels(canvas.clientHeight)];
        if (canvas.width !== width || canvas.height !== height)
            Object.assign(canvas, { width, height });
    }

    program(sources) {
        const { gl } = this, program = gl.createProgram();
        [gl.VERTEX_SHADER, gl.FRAGMENT_SHADER].forEach((type, i) => {
            const shader = gl.createShader(type);
            gl.shaderSource(shader, sources[i]);
            gl.compileShader(shader);
            gl.attachShader(program, shader);
        });
        gl.linkProgram(program);
        if (!gl.getProgramParameter(program, gl.LINK_STATUS))
            throw new Error(gl.getProgramInfoLog(program));
        const uniforms = {};
        for (let i = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) - 1; i >= 0; --i) {
            const { name } = gl.getActiveUniform(program, i);
            uniforms[name] = gl.getUniformLocation(program, name);
        }
        return { program, uniforms };
    }

    buffer(values) {
        const { gl } = this, buffer = gl.createBuffer();
        gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
        gl.bufferData(gl.ARRAY_BUFFER, values, gl.DYNAMIC_DRAW);
        return buffer;
    }
    array(describe) {
        const { gl } = this, array = gl.createVertexArray();
        gl.bindVertexArray(array);
        describe();
        gl.bindVertexArray(null);
        return array;
    }

    /** Takes what Surface.triangles and Surface.colors return. */
    makeTriangles(corners, colors) {
        const { gl } = this, buffers = [this.buffer(corners), this.buffer(colors)];
        const array = this.array(() => {
            gl.bindBuffer(gl.ARRAY_BUFFER, buffers[0]);
            gl.enableVertexAttribArray(0);
            gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 16, 0);
            gl.enableVertexAttribArray(1);
            gl.vertexAttribPointer(1, 3, gl.BYTE, true, 16, 12);
            gl.bindBuffer(gl.ARRAY_BUFFER, buffers[1]);
            gl.enableVertexAttribArray(2);
            gl.vertexAttribPointer(2, 4, gl.UNSIGNED_BYTE, true, 4, 0);
        });
        return { array, buffers, count: corners.length / 16 };
    }
    setColors({ buffers }, colors) {
        this.gl.bindBuffer(this.gl.ARRAY_BUFFER, buffers[1]);
        this.gl.bufferSubData(this.gl.ARRAY_BUFFER, 0, colors);
    }
    /** Takes pairs of points, three floats each. */
    makeLines(ends) {
        const { gl } = this, buffers = [this.buffer(ends)];
        const array = this.array(() => {
            for (const i of [0, 1]) {
                gl.enableVertexAttribArray(i);
                gl.vertexAttribPointer(i, 3, gl.FLOAT, false, 24, 12 * i);
                gl.vertexAttribDivisor(i, 1);
            }
        });
        return { array, buffers, count: ends.length / 6 };
    }
    free(made) {
        if (!made)
            return;
        this.gl.deleteVertexArray(made.array);
        made.buffers.forEach(buffer => this.gl.deleteBuffer(buffer));
    }

    /** Draws panels side by side: { triangles, lines: [{ made, width, ink, lift }] }, in pixels of the screen. */
    draw(camera, panels, density) {
        const { gl } = this, { width, height } = gl.canvas;
        gl.viewport(0, 0, width, height);
        gl.clearColor(1, 1, 1, 1);
        gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
        gl.enable(gl.DEPTH_TEST);
        gl.depthFunc(gl.LEQUAL);
        gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
        panels.forEach((panel, i) => {
            const window = { width: Math.floor(width / panels.length), height };
            gl.viewport(i * window.width, 0, window.width, height);
            this.use("surface", camera, window);
            gl.enable(gl.POLYGON_OFFSET_FILL);
            gl.polygonOffset(1, 1);
            gl.bindVertexArray(panel.triangles.array);
            gl.drawArrays(gl.TRIANGLES, 0, panel.triangles.count);
            gl.disable(gl.POLYGON_OFFSET_FILL);
            const uniforms = this.use("lines", camera, window);
            gl.uniform2f(uniforms.pixels, window.width, window.height);
            gl.enable(gl.BLEND);
            for (const { made, width, ink, lift } of panel.lines) {
                gl.uniform1f(uniforms.width, width * density);
                gl.uniform1f(uniforms.lift, lift);
                gl.uniform4fv(uniforms.ink, ink);
                gl.bindVertexArray(made.array);
                gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, made.count);
            }
            gl.disable(gl.BLEND);
        });
    }

    use(name, camera, window) {
        const { gl } = this, { program, uniforms } = this.programs[name];
        gl.useProgram(program);
        for (const axis of ["right", "up", "toward", "center"])
            gl.uniform3fv(uniforms[axis], camera[axis]);
        const scale = 2 * camera.pixelsPerUnit(window);
        gl.uniform2f(uniforms.scale, scale / window.width, scale / window.height);
        gl.uniform1f(uniforms.depth, 1.01 * camera.depth);
        return uniforms;
    }
}
