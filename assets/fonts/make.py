"""Cuts the fonts down to the characters in use: see make.sh."""

from pathlib import Path

from fontTools import subset
from fontTools.fontBuilder import FontBuilder
from fontTools.pens.t2CharStringPen import T2CharStringPen
from fontTools.pens.ttGlyphPen import TTGlyphPen
from fontTools.ttLib import TTFont

HERE = Path(__file__).parent
ROOT = HERE.parent.parent
DEBIAN = Path("/usr/share/fonts")
INTER = "opentype/inter/Inter-%s.otf"
DEJAVU = "truetype/dejavu/DejaVu%s.ttf"
CJK = "opentype/noto/NotoSansCJK-%s.ttc"
SIMPLIFIED_CHINESE = 2  # the face in Noto's collection

# A family falls back from font to font; each file holds only what the ones before it lack.
FAMILIES = [
    [("Inter-Regular.otf", INTER % "Regular", -1),
     ("DejaVuSans.ttf", DEJAVU % "Sans", -1),
     ("NotoSansSC-Regular.otf", CJK % "Regular", SIMPLIFIED_CHINESE)],
    [("Inter-SemiBold.otf", INTER % "SemiBold", -1),
     ("DejaVuSans-Bold.ttf", DEJAVU % "Sans-Bold", -1),
     ("NotoSansSC-Bold.otf", CJK % "Bold", SIMPLIFIED_CHINESE)],
    [("JetBrainsMono-Regular.ttf", "truetype/jetbrains-mono/JetBrainsMono-Regular.ttf", -1),
     ("DejaVuSansMono.ttf", DEJAVU % "SansMono", -1)],
]

# No font at hand has these three: drawn here, as boxes and triangles of a 1000-unit square.
LOW, HIGH, MIDDLE = 60, 700, 380
BAR = 110
SYMBOLS = {
    "⏸": [[(110, LOW), (240, LOW), (240, HIGH), (110, HIGH)],
          [(360, LOW), (490, LOW), (490, HIGH), (360, HIGH)]],
    "⏮": [[(60, LOW), (60 + BAR, LOW), (60 + BAR, HIGH), (60, HIGH)],
          [(540, LOW), (540, HIGH), (170, MIDDLE)]],
    "⏭": [[(60, LOW), (430, MIDDLE), (60, HIGH)],
          [(430, LOW), (430 + BAR, LOW), (430 + BAR, HIGH), (430, HIGH)]],
}


def used_characters():
    text = (HERE / "extra-chars.txt").read_text()
    for pattern in ("assets/messages/**/*.ftl", "assets/glossary/*.toml", "lessons/**/*.md", "lessons/**/*.toml"):
        text += "".join(p.read_text() for p in ROOT.glob(pattern))
    for path in ROOT.glob("src/**/*.rs"):
        lines = path.read_text().splitlines()
        text += "".join(line for line in lines if not line.lstrip().startswith("//"))
    latin = [*range(0x20, 0x7F), *range(0xA0, 0x100)]
    return {ord(c) for c in text if ord(c) >= 0x20 and c != "\u007f"} | set(latin)


def widen_minus(font):
    """JetBrains Mono draws its minus as a hyphen: here it is as wide as the plus."""
    names, outlines = font.getBestCmap(), font["glyf"]
    minus, plus = names[ord("−")], outlines[names[ord("+")]]
    low, high = outlines[minus].yMin, outlines[minus].yMax
    pen = TTGlyphPen(None)
    pen.moveTo((plus.xMin, low))
    for corner in [(plus.xMin, high), (plus.xMax, high), (plus.xMax, low)]:
        pen.lineTo(corner)
    pen.closePath()
    outlines[minus] = pen.glyph()
    font["hmtx"][minus] = (font["hmtx"][minus][0], plus.xMin)


def cut(target, source, face, characters):
    """Writes the subset, if there is anything in it; returns what is still missing."""
    font = TTFont(DEBIAN / source, fontNumber=face, recalcTimestamp=False)
    present = characters & set(font.getBestCmap())
    options = subset.Options()
    # No contextual alternates and ligatures: code is shown as it is written.
    options.layout_features = ["kern", "mark", "mkmk", "ccmp", "locl"]
    options.name_IDs = [0, 1, 2, 3, 4, 5, 6, 13, 14]
    options.notdef_outline = True
    options.recalc_timestamp = False
    options.desubroutinize = True
    options.drop_tables += ["vhea", "vmtx", "VORG", "BASE", "DSIG", "FFTM", "meta"]
    cutter = subset.Subsetter(options)
    cutter.populate(unicodes=present)
    cutter.subset(font)
    if target.startswith("JetBrainsMono"):
        widen_minus(font)
    subset.save_font(font, HERE / target, options)
    print(f"{target:28} {len(present):5} characters {(HERE / target).stat().st_size:8} bytes")
    return characters - present


def draw_symbols(target):
    names = {c: f"uni{ord(c):04X}" for c in SYMBOLS}
    builder = FontBuilder(1000, isTTF=False)
    builder.setupGlyphOrder([".notdef", *names.values()])
    builder.setupCharacterMap({ord(c): name for c, name in names.items()})
    glyphs = {".notdef": T2CharStringPen(600, None).getCharString()}
    for character, outlines in SYMBOLS.items():
        pen = T2CharStringPen(600, None)
        for first, *rest in outlines:
            pen.moveTo(first)
            for point in rest:
                pen.lineTo(point)
            pen.closePath()
        glyphs[names[character]] = pen.getCharString()
    builder.setupCFF("ClipscopeSymbols", {"FullName": "Clipscope Symbols"}, glyphs, {})
    builder.setupHorizontalMetrics({name: (600, 0) for name in glyphs})
    builder.setupHorizontalHeader(ascent=800, descent=-200)
    builder.setupNameTable({"familyName": "Clipscope Symbols", "styleName": "Regular"})
    builder.setupOS2(sTypoAscender=800, sTypoDescender=-200, usWinAscent=800, usWinDescent=200)
    builder.setupPost(keepGlyphNames=False)
    builder.updateHead(created=0, modified=0)
    builder.font.recalcTimestamp = False
    builder.save(HERE / target)


def main():
    characters = used_characters() - {ord(c) for c in SYMBOLS}
    draw_symbols("ClipscopeSymbols.otf")
    for family in FAMILIES:
        missing = characters
        for target, source, face in family:
            missing = cut(target, source, face, missing)
        # The monospace family ends in the same Chinese font as the text.
        if len(family) == 3 and missing:
            print("  in none of them:", " ".join(f"U+{c:04X}" for c in sorted(missing)))


main()
