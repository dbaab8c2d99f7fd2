// What lies over the bodies: cells of the grid, outlines of what is tested, contacts, forces.
import {
    BufferGeometry, Color, EdgesGeometry, Float32BufferAttribute, LineBasicMaterial, LineSegments, Points, PointsMaterial,
} from 'three';
import { kNeutral } from '../palette.js';
import { ofCluster, testedColours } from './cluster_colours.js';

const kContact = '#d55e00', kForce = '#cc79a7', kContactPixels = 6;
const kEdges = [[0, 1], [0, 2], [0, 4], [1, 3], [1, 5], [2, 3], [2, 6], [3, 7], [4, 5], [4, 6], [5, 7], [6, 7]];

function corner([x, y, z], edges, i) {
    return [x + (i & 1 ? edges : 0), y + (i & 2 ? edges : 0), z + (i & 4 ? edges : 0)];
}

function boxLines(lowest, edge) {
    return kEdges.flatMap(([from, to]) => [...corner(lowest, edge, from), ...corner(lowest, edge, to)]);
}

function lines(positions, colours, plain) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new Float32BufferAttribute(positions, 3));
    if (colours) geometry.setAttribute('color', new Float32BufferAttribute(colours, 3));
    return new LineSegments(geometry, new LineBasicMaterial(colours ? { vertexColors: 2 } : { color: plain }));
}

// The grid is a cube around its centre; cells are counted from its lowest corner.
function cells(recording, { grid, cells: occupied }) {
    const half = grid.cells * grid.edge / 2, lowest = grid.centre.map(middle => middle - half);
    const positions = boxLines(lowest, grid.cells * grid.edge), colours = [];
    const add = (shade, count) => { for (let i = 0; i < count; ++i) colours.push(shade.r, shade.g, shade.b); };
    add(new Color(kNeutral), 2 * kEdges.length);
    for (const [x, y, z, cluster] of occupied) {
        positions.push(...boxLines([x, y, z].map((place, i) => lowest[i] + place * grid.edge), grid.edge));
        add(ofCluster(recording, cluster), 2 * kEdges.length);
    }
    return lines(positions, colours);
}

// Edges of static geoms in the colours of the clusters with which they are tested, by turns.
function tested(recording, frame, meshes) {
    const positions = [], colours = [];
    meshes.forEach((mesh, i) => {
        const shades = testedColours(recording, frame.memberships[i], mesh.userData.body < 0);
        if (shades.length === 0 || mesh.userData.isPlane) return;
        mesh.updateMatrix();
        const edges = new EdgesGeometry(mesh.geometry).applyMatrix(mesh.matrix).getAttribute('position');
        for (let corner = 0; corner < edges.count; ++corner) {
            positions.push(edges.getX(corner), edges.getY(corner), edges.getZ(corner));
            const shade = shades[Math.floor(corner / 2) % shades.length];
            colours.push(shade.r, shade.g, shade.b);
        }
    });
    return lines(positions, colours);
}

function contacts({ contacts: found }) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new Float32BufferAttribute(found.flatMap(contact => contact.slice(2, 5)), 3));
    return new Points(geometry, new PointsMaterial({ color: kContact, size: kContactPixels, sizeAttenuation: false, depthTest: false }));
}

// The longest arrow of a frame is a quarter of what is seen.
function forces({ contacts: found }, { radius }) {
    const sizes = found.map(contact => Math.hypot(...contact.slice(8, 11)));
    const scale = radius / 4 / Math.max(1e-9, ...sizes);
    return lines(found.flatMap(contact => {
        const at = contact.slice(2, 5);
        return [...at, ...at.map((value, i) => value + scale * contact[8 + i])];
    }), null, kForce);
}

// Each makes what is drawn over a frame; null: nothing.
export const kOverlays = {
    cells: {
        text: 'grid cells', needs: 'clusters',
        make: ({ recording, frame }) => frame.grid.cells > 0 ? cells(recording, frame) : null,
    },
    tested: {
        text: 'clusters that static geoms are tested with', needs: 'clusters',
        make: ({ recording, frame, meshes }) => tested(recording, frame, meshes),
    },
    contacts: { text: 'contacts', needs: 'contacts', make: ({ frame }) => frame.contacts ? contacts(frame) : null },
    forces: {
        text: 'contact forces', needs: 'contacts',
        make: ({ frame, bounds }) => frame.contacts ? forces(frame, bounds) : null,
    },
};
