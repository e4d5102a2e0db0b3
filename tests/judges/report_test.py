"""The report in headless Chromium: at desktop, phone and print size, light and dark. Nothing overflows, text stands out
from what is behind it, headings are in order, nothing is said by colour alone, no script and nothing from elsewhere."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

CGW = os.environ["CGW"]
SAMPLES = pathlib.Path(os.environ["CGW_SAMPLES"])
CHROMIUM = shutil.which("chromium")
OLD, PLANT = SAMPLES / "genset.toml", SAMPLES / "manual-example.toml"

# Runs beside the page, in the frame that holds it; what it finds becomes the text of the document.
PROBE = """
function luminance(rgb) {
  const part = rgb.map(v => { v /= 255; return v <= 0.03928 ? v / 12.92 : Math.pow((v + 0.055) / 1.055, 2.4); });
  return 0.2126 * part[0] + 0.7152 * part[1] + 0.0722 * part[2];
}
function colour(text) { const m = text.match(/[\\d.]+/g).map(Number); return m.length < 4 || m[3] > 0 ? m : null; }
function behind(view, node) {
  for (; node; node = node.parentElement) {
    const found = colour(view.getComputedStyle(node).backgroundColor);
    if (found) return found.slice(0, 3);
  }
  return [255, 255, 255];
}
function probe(frame) {
  const view = frame.contentWindow, page = frame.contentDocument, root = page.documentElement;
  const result = { width: root.clientWidth, scroll: root.scrollWidth, small: [], faint: [], headings: [], spilled: [] };
  for (const node of page.querySelectorAll('body *')) {
    const own = [...node.childNodes].some(n => n.nodeType === 3 && n.textContent.trim());
    const box = node.getBoundingClientRect(), style = view.getComputedStyle(node);
    if (/^H[1-6]$/.test(node.tagName)) result.headings.push(Number(node.tagName[1]));
    if (!own || box.width === 0) continue;
    const svg = node.namespaceURI.endsWith('svg');
    if (!node.closest('.wide') && (box.right > root.clientWidth + 1 || box.left < -1)) result.spilled.push(node.textContent);
    if (!svg && parseFloat(style.fontSize) < 11) result.small.push(node.textContent);
    if (svg) continue;
    const ink = luminance(colour(style.color)), paper = luminance(behind(view, node));
    const contrast = (Math.max(ink, paper) + 0.05) / (Math.min(ink, paper) + 0.05);
    if (contrast < 4.5) result.faint.push(contrast.toFixed(2) + ' ' + node.textContent);
  }
  return result;
}
"""


def chromium(*arguments, directory):
    home = directory / "profile"
    return subprocess.run([CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
                           "--disable-dev-shm-usage", f"--user-data-dir={home}", *map(str, arguments)],
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=240)


@unittest.skipUnless(CHROMIUM, "no Chromium")
class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.dir = pathlib.Path(tempfile.mkdtemp(prefix="cgw-report-"))
        cls.addClassCleanup(shutil.rmtree, cls.dir, ignore_errors=True)
        result = subprocess.run([CGW, "emit", "report", str(PLANT), "--against", str(OLD), "-o", str(cls.dir / "report.html")],
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=120)
        assert result.returncode == 0, result.stderr
        cls.html = (cls.dir / "report.html").read_text()

    def probe(self, width, dark=False):
        # What a dark screen would switch on is always on in this copy.
        html = self.html.replace("(prefers-color-scheme: dark)", "all") if dark else self.html
        (self.dir / "page.html").write_text(html)
        (self.dir / "probe.html").write_text(
            f"<!DOCTYPE html><html><body><iframe id=f src=page.html style='width:{width}px;height:900px;border:0'></iframe>"
            f"<pre id=out></pre><script>{PROBE}\nf.onload = () => out.textContent = JSON.stringify(probe(f));</script></body></html>")
        result = chromium("--allow-file-access-from-files", "--window-size=1400,1000", "--virtual-time-budget=8000",
                          "--dump-dom", (self.dir / "probe.html").as_uri(), directory=self.dir)
        found = re.search(r'<pre id="out">(.+?)</pre>', result.stdout.decode(), re.S)
        self.assertTrue(found, result.stderr.decode()[-2000:])
        text = found[1].replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&")
        return json.loads(text)

    def test_nothing_overflows_at_any_width(self):
        for width in (320, 390, 768, 1280):
            found = self.probe(width)
            self.assertEqual(found["width"], width)
            self.assertLessEqual(found["scroll"], width)
            self.assertEqual(found["spilled"], [], width)
            self.assertEqual(found["small"], [], width)

    def test_text_stands_out_in_light_and_dark(self):
        self.assertEqual(self.probe(1280)["faint"], [])
        self.assertEqual(self.probe(1280, dark=True)["faint"], [])

    def test_headings_are_in_order(self):
        levels = self.probe(1280)["headings"]
        self.assertEqual(levels[0], 1)
        self.assertEqual(levels.count(1), 1)
        for above, below in zip(levels, levels[1:]):
            self.assertLessEqual(below, above + 1)

    def test_nothing_is_said_by_colour_alone(self):
        # A coloured text says its verdict in words: a level, "in time", or the mark before it.
        words = re.compile(r"OK|Warning|Error|error|warning|note|ms$|%$|no bound|in time|late|wait")
        for tone, text in re.findall(r'<span class="(good|warning|bad)">(.*?)</span>', self.html):
            self.assertRegex(re.sub("<.*?>", "", text), words, tone)
        for svg in re.findall(r"<svg[^>]*>", self.html):
            self.assertIn('role="img" aria-label="', svg)

    def test_it_needs_no_script_and_nothing_from_elsewhere(self):
        self.assertNotRegex(self.html, r"<script|https?:|url\(|@import|<link|<img|<iframe")

    def test_it_is_well_formed(self):
        result = subprocess.run(["xmllint", "--noout", str(self.dir / "report.html")], stderr=subprocess.PIPE, timeout=60)
        self.assertEqual((result.returncode, result.stderr), (0, b""))

    def test_it_prints_on_a4(self):
        pdf = self.dir / "report.pdf"
        chromium("--no-pdf-header-footer", f"--print-to-pdf={pdf}", (self.dir / "report.html").as_uri(), directory=self.dir)
        self.assertTrue(pdf.exists())
        info = subprocess.run(["pdfinfo", str(pdf)], stdout=subprocess.PIPE, text=True, check=True, timeout=60).stdout
        self.assertRegex(info, r"Page size: +59[45]\S* x 84[12]")
        text = subprocess.run(["pdftotext", "-layout", str(pdf), "-"], stdout=subprocess.PIPE, text=True, check=True,
                              timeout=60).stdout
        for part in ("Entry sheets", "Reset BOTH devices", "TPDO16", "Changes", "CanOpenMyNodeID"):
            self.assertIn(part, text)

    def test_pictures_at_three_sizes_hold_something(self):
        for name, width, height in (("desktop", 1280, 900), ("tablet", 820, 1100), ("phone", 500, 900)):
            picture = self.dir / f"{name}.png"
            chromium(f"--window-size={width},{height}", f"--screenshot={picture}", (self.dir / "report.html").as_uri(),
                     directory=self.dir)
            data = picture.read_bytes()
            self.assertEqual(data[:8], b"\x89PNG\r\n\x1a\n")
            self.assertEqual((int.from_bytes(data[16:20], "big"), int.from_bytes(data[20:24], "big")), (width, height))
            self.assertGreater(len(data), 20_000)  # an empty page has a tenth of that


if __name__ == "__main__":
    unittest.main()
