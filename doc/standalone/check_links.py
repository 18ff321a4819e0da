#!/usr/bin/env python3
# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks links: check_links.py PATH...

Of a folder of HTML, all links to files and anchors in it; of a Markdown file, those to files and headings. Links to other hosts
are checked for their form alone. Prints each link that leads nowhere, and fails if there is one.
"""

import re
import sys
from functools import lru_cache
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit


class Page(HTMLParser):
    """The links and the anchors of an HTML file."""

    def __init__(self, file):
        super().__init__()
        self.links, self.anchors = [], set()
        self.feed(file.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("href", "src") and value:
                self.links.append(value)
            elif name == "id" or name == "name" and tag == "a":
                self.anchors.add(value)


def heading_anchor(heading):
    """As the usual viewers of Markdown make it."""
    text = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading)
    return re.sub(r"[^\w\- ]", "", text.strip().lower()).replace(" ", "-")


class Markdown:
    """The links and the headings of a Markdown file, without its code."""

    def __init__(self, file):
        self.links, self.anchors = [], set()
        text = re.sub(r"^```.*?^```", "", file.read_text(encoding="utf-8"), flags=re.M | re.S)
        text = re.sub(r"<!--.*?-->", "", text, flags=re.S)
        text = re.sub(r"^    .*$", "", text, flags=re.M)
        for heading in re.findall(r"^#+ +(.*?) *#*$", text, re.M):
            anchor = base = heading_anchor(heading.replace("`", ""))
            number = 0
            while anchor in self.anchors:
                number += 1
                anchor = f"{base}-{number}"
            self.anchors.add(anchor)
        text = re.sub(r"`[^`\n]*`", "", text)
        self.links = re.findall(r"\]\(<?([^)\s>]+)>?(?: \"[^\"]*\")?\)", text)
        self.links += re.findall(r"^\[[^]]+\]: *(\S+)", text, re.M)


@lru_cache(maxsize=None)
def document(file):
    if file.suffix == ".html":
        return Page(file)
    if file.suffix == ".md":
        return Markdown(file)
    return None


def fault(file, link):
    """What is wrong with a link in a file, if anything."""
    parts = urlsplit(link)
    if parts.scheme in ("http", "https"):
        host = re.fullmatch(r"[a-z0-9-]+(\.[a-z0-9-]+)+(:\d+)?", parts.netloc, re.I)
        return None if host and not re.search(r"[\s<>\"]", link) else "is not well-formed"
    if parts.scheme == "mailto":
        return None if re.fullmatch(r"[^@\s]+@[^@\s]+\.[^@\s]+", parts.path) else "is not well-formed"
    if parts.scheme == "javascript":
        return None
    if parts.scheme or parts.netloc or parts.path.startswith("/"):
        return "is not relative"
    target = file.parent / unquote(parts.path) if parts.path else file
    if not target.exists():
        return "leads to no file"
    known = document(target.resolve()) if parts.fragment and target.is_file() else None
    if known and unquote(parts.fragment) not in known.anchors:
        return "leads to no anchor"
    return None


def links_of(file):
    if file.suffix == ".js":  # the navigation
        return re.findall(r'"([\w.-]+\.html(?:#[^"]*)?)"', file.read_text(encoding="utf-8"))
    return document(file.resolve()).links


def main():
    files = []
    for path in map(Path, sys.argv[1:]):
        if path.is_dir():
            found = sorted(path.glob("*.html")) + sorted(path.glob("*.js"))
            if not found:
                sys.exit(f"{path} has no HTML")
            files += found
        else:
            files.append(path)
    if not files:
        sys.exit(__doc__)
    faults, number = 0, 0
    for file in files:
        links = links_of(file)
        number += len(links)
        for link in sorted(set(links)):
            what = fault(file, link)
            if what:
                print(f"{file}: the link {link} {what}", file=sys.stderr)
                faults += 1
    print(f"{number} links in {len(files)} files, {faults} faults")
    sys.exit(faults > 0)


if __name__ == "__main__":
    main()
