// The direction from which a page shows its surfaces. There is no perspective, as in the pictures of kith.

const add = (a, b, s = 1) => a.map((x, i) => x + s * b[i]);
const times = (a, s) => a.map(x => x * s);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

class Camera {
    constructor({ azimuth, elevation, up }) {
        this.home = { azimuth, elevation };
        // To the right, upward and away, for a viewer in front; see kith::picture::view.
        this.axes = [[[0, 1, 0], [1, 0, 0], [0, 0, 1]],
                     [[1, 0, 0], [0, 1, 0], [0, 0, -1]],
                     [[1, 0, 0], [0, 0, 1], [0, 1, 0]]][up];
        this.turnTo(azimuth, elevation);
    }

    turnTo(azimuth, elevation) {
        this.azimuth = azimuth;
        this.elevation = Math.min(Math.max(elevation, -90), 90);
        const [a, e] = [this.azimuth, this.elevation].map(degrees => degrees * Math.PI / 180);
        const [right, up, away] = this.axes;
        this.toward = add(times(add(times(right, Math.sin(a)), away, -Math.cos(a)), Math.cos(e)), up, Math.sin(e));
        this.right = add(times(right, Math.cos(a)), away, Math.sin(a));
        this.up = cross(this.toward, this.right);
    }

    /** Shows all points, from the direction in which the page began. */
    frame(points) {
        const least = [Infinity, Infinity, Infinity], most = [-Infinity, -Infinity, -Infinity];
        points.forEach((x, i) => {
            least[i % 3] = Math.min(least[i % 3], x);
            most[i % 3] = Math.max(most[i % 3], x);
        });
        this.center = times(add(least, most), .5);
        let farthest = 0;
        for (let i = 0; i < points.length; i += 3)
            farthest = Math.max(farthest, Math.hypot(...add(points.subarray(i, i + 3), this.center, -1)));
        this.radius = farthest || 1;
        this.shown = 1.1 * this.radius; // half of the shorter side of the window, in the units of the mesh
        this.turnTo(this.home.azimuth, this.home.elevation);
    }

    /** Turns by a movement in pixels. */
    orbit(x, y) { this.turnTo(this.azimuth - x * .4, this.elevation + y * .4); }
    pan(x, y, window) { this.center = add(this.center, this.inPlane(x, y, window), -1); }
    zoom(factor) {
        this.shown = Math.min(Math.max(this.shown / factor, this.radius * 1e-4), this.radius * 20);
    }

    pixelsPerUnit({ width, height }) { return Math.min(width, height) / 2 / this.shown; }
    /** Returns the vector that a movement in pixels stands for. */
    inPlane(x, y, window) {
        const scale = 1 / this.pixelsPerUnit(window);
        return add(times(this.right, x * scale), this.up, -y * scale);
    }
    /** Returns the place of a point in a window: x, y in pixels, and a depth that is larger nearer to the viewer. */
    project(point, window) {
        const scale = this.pixelsPerUnit(window), offset = add(point, this.center, -1);
        return [window.width / 2 + dot(offset, this.right) * scale,
                window.height / 2 - dot(offset, this.up) * scale,
                dot(offset, this.toward)];
    }
    /** Returns the ray from the viewer through a pixel: where it begins, and its direction. */
    ray(x, y, window) {
        const at = add(this.center, this.inPlane(x - window.width / 2, y - window.height / 2, window));
        return [add(at, this.toward, 4 * this.radius + this.shown), times(this.toward, -1)];
    }
}
