// Colours of clusters: of what moves, of static geoms by the clusters that they are in or are tested with, of cells.
import { Color } from 'three';
import { colour, kColourCount, kNeutral } from '../palette.js';

const kShades = [0, -0.18, 0.15];  // lightness: there are more numbers than colours
const kTint = 0.45, kPale = 0.7;          // share of white
const white = new Color('#ffffff'), unlisted = new Color('#f7f7f7'), apart = new Color(kNeutral);

// The same number has the same colour in every frame.
export function colourOf(number) {
    return new Color(colour(number)).offsetHSL(0, 0, kShades[Math.floor(number / kColourCount) % kShades.length]);
}

export function ofCluster({ clusterNumbers }, name) {
    return clusterNumbers.has(name) ? colourOf(clusterNumbers.get(name)) : apart;
}

// These passes list static geoms in each cluster that is near.
function listsStatics({ header }) {
    return ['duplication', 'decluster'].includes(header.algorithm);
}

function mixture(colours) {
    return colours.reduce((sum, shade, i) => sum.lerp(shade, 1 / (i + 1)), colours[0].clone());
}

export function ofGeom(recording, { cluster, static: staticCluster, testedWith }, isStatic) {
    if (!isStatic) return cluster === 0 ? white : ofCluster(recording, cluster);
    if (staticCluster !== 0) return colourOf(staticCluster - 1).lerp(white, kPale);
    if (!listsStatics(recording)) return apart;
    return testedWith.length === 0 ? unlisted : mixture(testedWith.map(name => ofCluster(recording, name))).lerp(white, kTint);
}

// The colours of the clusters with which a static geom is tested; none where it is tested with all or with none.
export function testedColours(recording, { cluster, testedWith }, isStatic) {
    return isStatic && cluster === 0 ? testedWith.map(name => ofCluster(recording, name)) : [];
}
