// A view of the replay as a part of the page's address, so that a link or a picture shows just that:
//   page.html#frame=400&colour=cluster&show=cells,contacts&azimuth=-50&elevation=30&distance=2.6&pick=3
// frame: number, or "last"; angles in degrees, as seen from the middle of what moves; distance in its radii.

function numberOf(words, name) {
    const value = Number(words.get(name));
    return words.has(name) && Number.isFinite(value) ? value : undefined;
}

function isOption(id, value) {
    const options = document.getElementById(id)?.options ?? [];
    return [...options].some(option => option.value === value);
}

function showOverlays(replay, names) {
    for (const name of names) {
        const box = document.getElementById(`replay-${name}`);
        if (box?.type !== 'checkbox') continue;
        box.checked = true;
        replay.showOverlay(name, true);
    }
}

// Words that are unknown, or that the recording has nothing for, change nothing.
export function followAddress(replay, address) {
    const words = new URLSearchParams(address.slice(1));
    const frame = words.get('frame') === 'last' ? Infinity : numberOf(words, 'frame');
    if (frame !== undefined) replay.player.goToNumber(frame);
    const colour = words.get('colour');
    if (isOption('replay-colour', colour)) {
        document.getElementById('replay-colour').value = colour;
        replay.colourBy(colour);
    }
    showOverlays(replay, (words.get('show') ?? '').split(',').filter(Boolean));
    const body = numberOf(words, 'pick');
    if (replay.player.frame.bodies[body]) replay.pick(body);
    const [azimuth, elevation, distance] = ['azimuth', 'elevation', 'distance'].map(name => numberOf(words, name));
    replay.viewpoint.place({ azimuth, elevation, distance });
}
