// The direction from which a page shows its surfaces. There is no perspective, as in the pictures of kith.

const add = (a, b, s = 1) => a.map((x, i) => x + s * b[i]);
const times = (a, s) => a.map(x => x * s);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** The viewer. The frame is the space in which the mesh has its middle at 0 and a radius of 1. */
class Camera {
    constructor({ azimuth, elevation, up }) {
        this.home = { azimuth, elevation };
        // To the right, upward and away, for a viewer in front; see kith::picture::view.
        this.axes = [[[0, 1, 0], [1, 0, 0], [0, 0, 1]],
                     [[1, 0, 0], [0, 1, 0], [0, 0, -1]],
                     [[1, 0, 0], [0, 0, 1], [0, 1, 0]]][up];
    }

    /** Takes the frame of a mesh with these points, and shows it. */
    measure(points) {
        const least = [Infinity, Infinity, Infinity], most = [-Infinity, -Infinity, -Infinity];
        points.forEach((x, i) => {
            least[i % 3] = Math.min(least[i % 3], x);
            most[i % 3] = Math.max(most[i % 3], x);
        });
        this.origin = add(times(least, .5), most, .5);
        this.unit = 0;
        for (let i = 0; i < points.length; i += 3)
            this.unit = Math.max(this.unit, Math.hypot(...add(points.subarray(i, i + 3), this.origin, -1)));
        this.unit ||= 1;
        this.reach = 1;
        this.goHome();
    }
    /** Widens what is drawn to a point of the mesh that has moved. */
    include(point) { this.reach = Math.max(this.reach, Math.hypot(...this.inFrame(point))); }

    /** Shows everything, from the direction in which the page began. */
    goHome() {
        this.center = [0, 0, 0];
        this.shown = 1.1 * this.reach; // half of the shorter side of the window
        this.turnTo(this.home.azimuth, this.home.elevation);
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

    /** Turns by a movement in pixels. */
    orbit(x, y) { this.turnTo(this.azimuth - x * .4, this.elevation + y * .4); }
    pan(x, y, window) { this.center = add(this.center, this.inPlane(x, y, window), -1); }
    zoom(factor) { this.shown = Math.min(Math.max(this.shown / factor, 1e-4), 20 * this.reach); }

    /** Returns the largest distance of anything that is drawn from the center. */
    get depth() { return this.reach + Math.hypot(...this.center); }
    inFrame(point) { return times(add(point, this.origin, -1), 1 / this.unit); }
    pixelsPerUnit({ width, height }) { return Math.min(width, height) / 2 / this.shown; }
    /** Returns the vector of the frame that a movement in pixels stands for. */
    inPlane(x, y, window) {
        const scale = 1 / this.pixelsPerUnit(window);
        return add(times(this.right, x * scale), this.up, -y * scale);
    }
    /** Returns a point of the mesh after a movement in pixels. */
    moved(point, x, y, window) { return add(point, this.inPlane(x, y, window), this.unit); }

    /** Returns the place of a point of the frame in a window: x, y in pixels, and a depth that grows to the viewer. */
    project(point, window) {
        const scale = this.pixelsPerUnit(window), offset = add(point, this.center, -1);
        return [window.width / 2 + dot(offset, this.right) * scale,
                window.height / 2 - dot(offset, this.up) * scale,
                dot(offset, this.toward)];
    }
    /** Returns the ray from the viewer through a pixel, in the frame: where it begins, and its direction. */
    ray(x, y, window) {
        const at = add(this.center, this.inPlane(x - window.width / 2, y - window.height / 2, window));
        return [add(at, this.toward, 2 * this.depth), times(this.toward, -1)];
    }
}
