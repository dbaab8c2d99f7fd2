// A recording of odemt_record (docs/clusters.md describes its members), with what the page asks for most.

// Members that a recording may lack: those that were not asked for, or that earlier versions did not record.
function parts(frames) {
    return {
        clusters: frames.some(frame => frame.grid.cells > 0),
        islands: frames.every(frame => frame.islands),
        threads: frames.every(frame => frame.workers),
        sleep: frames.every(frame => frame.awake),
        velocities: frames.every(frame => frame.velocities),
        contacts: frames.every(frame => frame.contacts),
    };
}

// Numbers of the clusters by name, in the order in which they come: names are large, and colours are few.
function numbersOfClusters(frames) {
    const numbers = new Map();
    for (const frame of frames)
        for (const { cluster } of frame.memberships)
            if (cluster !== 0 && !numbers.has(cluster)) numbers.set(cluster, numbers.size);
    return numbers;
}

export function parseRecording({ name, otherWorld, text }) {
    const lines = text.trimEnd().split('\n').map(line => JSON.parse(line));
    const { recording: header } = lines.shift();
    const frames = lines.map(line => line.frame);
    const byNumber = new Map(frames.map(frame => [frame.number, frame]));
    return { name, otherWorld, header, frames, has: parts(frames), byNumber, clusterNumbers: numbersOfClusters(frames) };
}

// Returns how the recording is called above its picture.
export function titleOf({ name, header, has }) {
    const library = has.clusters || header.algorithm ? `ODE_MT, ${header.algorithm}` : 'libode8';
    return `${library} (${name.split('/').pop()})`;
}

// "body 3", "body 3 (create::left wheel)".
export function bodyText({ header }, body) {
    const name = header.bodyNames?.[body];
    return name ? `body ${body} (${name})` : `body ${body}`;
}

export function missingParts({ has }) {
    const words = {
        clusters: 'clusters and grid', islands: 'islands', sleep: 'which bodies sleep', velocities: 'velocities',
        contacts: 'contacts and forces (odemt_record --contacts)', threads: 'which thread stepped which body (odemt_record --threads)',
    };
    return Object.keys(words).filter(part => !has[part]).map(part => words[part]);
}
