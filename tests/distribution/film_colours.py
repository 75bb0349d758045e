"""Whether a film shows the colours that were drawn.

Codecs keep neither single pixels nor the colour of thin lines, so both are reduced to blocks, and over all blocks a linear
map from drawn colours to decoded luma is fitted. Of a film that is stored and read by the same matrix this is BT.709's
luma, and within a few steps it is so for a whole pure colour too; read by another matrix, or in another range, pure
colours and black end up elsewhere.
"""

BLOCK_PX = 16
LUMA = (0.2126, 0.7152, 0.0722, 0.0)
PURE = {"red": (255, 0, 0, 1), "green": (0, 255, 0, 1), "blue": (0, 0, 255, 1), "black": (0, 0, 0, 1)}
# Measured: at most 3 when all is right; 33 for the matrix of BT.601, 16 for the wrong range.
MOST_LUMA_ERROR = 8
LEAST_COLOUR = 40  # of the most colourful block: without colour nothing can be told
LEAST_COLOUR_KEPT = 0.5


def blocks(rgb, width, height):
    """The mean colour of each block of a picture, three bytes each; incomplete blocks at the right and below count too."""
    if len(rgb) != width * height * 3:
        raise ValueError(f"{len(rgb)} bytes are no picture of {width}x{height}")
    found = bytearray()
    for top in range(0, height, BLOCK_PX):
        rows = [rgb[y * width * 3:(y + 1) * width * 3] for y in range(top, min(top + BLOCK_PX, height))]
        for left in range(0, width * 3, BLOCK_PX * 3):
            for channel in range(3):
                values = [value for row in rows for value in row[left + channel:left + BLOCK_PX * 3:3]]
                found.append(round(sum(values) / len(values)))
    return bytes(found)


def colours(means):
    return zip(means[::3], means[1::3], means[2::3], strict=True)


def colourful(means):
    """How far the most colourful block is from grey."""
    return max(max(colour) - min(colour) for colour in colours(means))


def product(a, b):
    return sum(x * y for x, y in zip(a, b, strict=True))


def solved(rows):
    """The solution of linear equations, each a row that ends in its right side."""
    for i in range(len(rows)):
        pivot = max(range(i, len(rows)), key=lambda r: abs(rows[r][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for r in range(len(rows)):
            if r != i:
                factor = rows[r][i] / rows[i][i]
                rows[r] = [x - factor * y for x, y in zip(rows[r], rows[i], strict=True)]
    return [row[-1] / row[i] for i, row in enumerate(rows)]


def fitted_luma(drawn, decoded):
    """The decoded luma as factors of drawn red, green, blue and 1, by least squares."""
    inputs = [(*colour, 1.0) for colour in colours(drawn)]
    lumas = [product(LUMA, (*colour, 1.0)) for colour in colours(decoded)]
    return solved([[sum(x[i] * x[j] for x in inputs) for j in range(4)] +
                   [sum(x[i] * luma for x, luma in zip(inputs, lumas, strict=True))] for i in range(4)])


def colours_fault(drawn, decoded):
    """Why the blocks of a film's frame are not those of the picture; empty when they are."""
    if colourful(drawn) < LEAST_COLOUR:
        return f"the picture has too little colour to tell ({colourful(drawn)} of 255)"
    if colourful(decoded) < LEAST_COLOUR_KEPT * colourful(drawn):
        return f"it has lost its colours ({colourful(decoded)} of {colourful(drawn)})"
    factors = fitted_luma(drawn, decoded)
    wrong = {name: round(product(factors, pure) - product(LUMA, pure)) for name, pure in PURE.items()}
    worst = max(wrong, key=lambda name: abs(wrong[name]))
    return f"decoded, the luma of pure {worst} is off by {wrong[worst]}" if abs(wrong[worst]) > MOST_LUMA_ERROR else ""
