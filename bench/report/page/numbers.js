// Numbers as the bench's own tables write them: three significant digits.

export function number(value) {
    if (value === null || value === undefined || !Number.isFinite(value)) return '–';
    if (value === 0) return '0';
    const size = Math.abs(value);
    if (size >= 1e6 || size < 1e-4) return value.toExponential(2);
    return size >= 100 ? value.toFixed(0) : value.toPrecision(3);
}

export function milliseconds(seconds) {
    return number(seconds === null || seconds === undefined ? null : 1000 * seconds);
}

// Returns "2.15 [2.01, 2.30]": median and quartiles.
export function spread(quantiles) {
    if (!quantiles || quantiles.median === null) return '–';
    return `${number(quantiles.median)} [${number(quantiles.lowerQuartile)}, ${number(quantiles.upperQuartile)}]`;
}

export function percent(share) {
    return `${Math.round(100 * share)} %`;
}
