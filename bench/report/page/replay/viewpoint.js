// One camera for all pictures: the mouse on any of them, or the keyboard, moves it.
import { PerspectiveCamera, Spherical, Vector3 } from 'three';
import { OrbitControls } from 'three-controls';

export const kDegree = Math.PI / 180, kFieldOfView = 45;  // degrees
const kDistance = 2.7;  // in radii of what moves: a sphere of that radius is seen whole from 1 / sin(22.5 degrees) of them on
const kNearest = 0.01, kFarthest = 1000;

export class Viewpoint {
    constructor({ centre, radius }, canvases, onChange) {
        this.camera = new PerspectiveCamera(kFieldOfView, 1, kNearest * radius, kFarthest * radius);
        this.camera.up.set(0, 0, 1);
        this.camera.position.copy(centre).add(new Vector3(0.6, -0.7, 0.45).normalize().multiplyScalar(kDistance * radius));
        this.camera.lookAt(centre);
        this.radius = radius;
        this.onChange = onChange;
        this.controls = canvases.map(canvas => {
            const controls = new OrbitControls(this.camera, canvas);
            controls.target.copy(centre);
            controls.enableKeys = false;
            controls.update();
            controls.addEventListener('change', () => this.follow(controls));
            return controls;
        });
    }

    // Panning one picture pans the others.
    follow(moved) {
        for (const controls of this.controls) controls.target.copy(moved.target);
        this.onChange();
    }

    // Angles in radians: around the vertical, and up.
    orbit(around, up) {
        this.change(spherical => {
            spherical.theta += around;
            spherical.phi -= up;
        });
    }

    // Degrees, and a multiple of the radius of what moves; what is undefined stays as it is.
    place({ azimuth, elevation, distance }) {
        this.change(spherical => {
            if (azimuth !== undefined) spherical.theta = azimuth * kDegree;
            if (elevation !== undefined) spherical.phi = (90 - elevation) * kDegree;
            if (distance !== undefined) spherical.radius = distance * this.radius;
        });
    }

    zoom(factor) {
        this.change(spherical => { spherical.radius /= factor; });
    }

    // three.js counts spherical coordinates from y.
    change(alter) {
        const { target } = this.controls[0];
        const offset = this.camera.position.clone().sub(target);
        const spherical = new Spherical().setFromVector3(new Vector3(offset.y, offset.z, offset.x));
        alter(spherical);
        spherical.makeSafe();
        const turned = new Vector3().setFromSpherical(spherical);
        this.camera.position.copy(target).add(new Vector3(turned.z, turned.x, turned.y));
        this.camera.lookAt(target);
        this.onChange();
    }
}
