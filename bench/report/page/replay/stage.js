// One recording in three dimensions. Draws when asked to; `z` is up, as in ODE's worlds.
import {
    AmbientLight, Color, DirectionalLight, DoubleSide, EdgesGeometry, LineBasicMaterial, LineSegments, Mesh, MeshLambertMaterial,
    Raycaster, Scene, Vector2, WebGLRenderer,
} from 'three';
import { themeColour } from '../palette.js';
import { isOutline, Shapes } from './shapes.js';
import { kDegree, kFieldOfView } from './viewpoint.js';

const kGround = 6, kBeyond = 1.3;  // planes reach so many radii of what moves, and beyond everything
const kGroundColour = '#cdd1d6';
const kSharpEdge = 20;             // degrees between faces whose common edge is drawn
const kSeeThrough = 0.25;          // opacity of shapes of which only the extent is known

// In degrees, so that a narrow picture shows from side to side what a wide one shows from top to bottom.
function verticalFieldOfView(aspect) {
    return 2 * Math.atan(Math.tan(kFieldOfView / 2 * kDegree) / Math.min(1, aspect)) / kDegree;
}

export class Stage {
    // Throws where the browser has no WebGL.
    constructor(canvas, recording, bounds) {
        this.recording = recording;
        this.canvas = canvas;
        // Kept for those who read the picture back: pictures for documents, and tests.
        this.renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
        this.scene = new Scene();
        this.scene.add(new AmbientLight(0xffffff, 0.55));
        this.light = new DirectionalLight(0xffffff, 0.6);
        this.scene.add(this.light);
        this.addGeoms(bounds);
        this.overlays = [];
        this.outlines = [];
        this.raycaster = new Raycaster();
    }

    addGeoms(bounds) {
        const shapes = new Shapes(bounds.centre, Math.max(kGround * bounds.radius, kBeyond * bounds.reach));
        this.geoms = this.recording.header.geoms.map((geom, i) => {
            const seeThrough = isOutline(geom);
            const material = new MeshLambertMaterial({ side: DoubleSide, transparent: seeThrough, opacity: seeThrough ? kSeeThrough : 1 });
            const mesh = new Mesh(shapes.of(geom), material);
            mesh.userData = { geom: i, body: geom.body, isPlane: geom.shape === 'plane' };
            this.scene.add(mesh);
            return mesh;
        });
    }

    show(frame) {
        frame.geoms.forEach(([x, y, z, qw, qx, qy, qz], i) => {
            this.geoms[i].position.set(x, y, z);
            this.geoms[i].quaternion.set(qx, qy, qz, qw);
        });
    }

    // `colourOf` gives the colour of a geom by its place and its body. Planes, which are everywhere, stay as they are.
    paint(colourOf) {
        for (const mesh of this.geoms)
            if (mesh.userData.isPlane) mesh.material.color.set(kGroundColour);
            else mesh.material.color.copy(colourOf(mesh.userData.geom, mesh.userData.body));
    }

    replace(olds, objects) {
        for (const old of olds) {
            this.scene.remove(old);
            old.geometry.dispose();
            old.material.dispose();
        }
        for (const object of objects) this.scene.add(object);
        return objects;
    }

    // Replaces what lies over the bodies.
    lay(objects) {
        this.overlays = this.replace(this.overlays, objects);
    }

    // The edges that mark a geom. Round shapes have no sharp ones: of these all are drawn.
    static edgesOf(geometry) {
        const sharp = new EdgesGeometry(geometry, kSharpEdge);
        return sharp.getAttribute('position').count > 0 ? sharp : new EdgesGeometry(geometry);
    }

    // Marks the geoms of a body, or none (null).
    mark(body) {
        const marked = body === null ? [] : this.geoms.filter(mesh => mesh.userData.body === body);
        this.outlines = this.replace(this.outlines, marked.map(mesh => {
            const edges = new LineSegments(Stage.edgesOf(mesh.geometry),
                new LineBasicMaterial({ color: themeColour('--text'), depthTest: false }));
            edges.position.copy(mesh.position);
            edges.quaternion.copy(mesh.quaternion);
            return edges;
        }));
    }

    // Returns the body under a point of the canvas (in pixels of the page); null: nothing, or static.
    bodyAt(x, y, camera) {
        const area = this.canvas.getBoundingClientRect();
        const point = new Vector2(2 * (x - area.left) / area.width - 1, 1 - 2 * (y - area.top) / area.height);
        this.raycaster.setFromCamera(point, camera);
        const hit = this.raycaster.intersectObjects(this.geoms)[0];
        return hit && hit.object.userData.body >= 0 ? hit.object.userData.body : null;
    }

    draw(camera) {
        const { clientWidth: width, clientHeight: height } = this.canvas;
        if (width === 0) return;
        this.renderer.setPixelRatio(devicePixelRatio);
        this.renderer.setSize(width, height, false);
        this.scene.background = new Color(themeColour('--surface'));
        this.light.position.copy(camera.position).add(camera.up);
        camera.aspect = width / height;
        camera.fov = verticalFieldOfView(camera.aspect);
        camera.updateProjectionMatrix();
        this.renderer.render(this.scene, camera);
    }
}
