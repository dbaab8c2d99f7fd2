// What odemt_report has put into the page.

// Returns the JSON file of the bench; null if there is none in the page.
export function embeddedResults() {
    const found = document.getElementById('results');
    return found && JSON.parse(found.textContent);
}

// Returns the recordings as { name, otherWorld, text }: JSON lines, compressed in the page; otherWorld: why it is not of the first one's world.
export async function embeddedRecordings() {
    return Promise.all([...document.querySelectorAll('script.recording')].map(async found => {
        const bytes = Uint8Array.from(atob(found.textContent), character => character.charCodeAt(0));
        const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
        return { name: found.dataset.name, otherWorld: found.dataset.otherWorld, text: await new Response(stream).text() };
    }));
}
