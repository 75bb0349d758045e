"""Whether a film shows the colours that were drawn: both reduced to blocks, for codecs do not keep single pixels."""

BLOCK_PX = 16
# What compression costs a block at most; colours read by another matrix differ by 20 and more where there is colour.
MOST_DIFFERENCE = 6


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


def colourful(means):
    """How far the most colourful block is from grey: without colour nothing can be told."""
    return max(max(means[i:i + 3]) - min(means[i:i + 3]) for i in range(0, len(means), 3))
