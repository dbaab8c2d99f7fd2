// What the JSON file of the bench says, in the order in which the page asks for it.

export const kParts = [
    ['frame', 'whole frame'], ['collision', 'collision'], ['dynamics', 'dynamics'], ['overhead', 'overhead'],
    ['callbacks', 'near-callbacks'], ['outside_callbacks', 'outside near-callbacks'],
];

export function partsOf(worlds) {
    return kParts.filter(([part]) => worlds.some(world => world.engines.some(engine => engine.parts?.[part])));
}

export function engineNames(worlds) {
    return [...new Set(worlds.flatMap(world => world.engines.map(engine => engine.engine)))];
}

export function engineOf(world, name) {
    return world.engines.find(engine => engine.engine === name && !engine.failure);
}

export function speedUp(world, name, part) {
    return engineOf(world, name)?.parts?.[part]?.speedUp ?? null;
}

// Engines that differ only in their number of threads: [["ours:N/lcp", [[1, "ours:1/lcp"], …]], …], two numbers or more each.
export function threadFamilies(names) {
    const families = new Map();
    for (const name of names) {
        const match = /^ours:(\d+)(.*)$/.exec(name);
        if (!match) continue;
        const family = `ours:N${match[2]}`;
        if (!families.has(family)) families.set(family, []);
        families.get(family).push([Number(match[1]), name]);
    }
    for (const points of families.values()) points.sort(([a], [b]) => a - b);
    return [...families].filter(([, points]) => points.length > 1);
}
