#!/bin/sh
# reference.sh BUILD CC VERSION : the reference of the public headers as HTML, in
# BUILD/reference. A warning of doxygen's is an error.
set -eu
tests/tools/need.sh doxygen:doxygen
rm -rf "$1/reference"
mkdir -p "$1/reference"
doxygen - <<END
PROJECT_NAME = Pel
PROJECT_NUMBER = $3
PROJECT_BRIEF = "Exact graphics in any framebuffer"
OUTPUT_DIRECTORY = "$1/reference"
HTML_OUTPUT = .
GENERATE_LATEX = NO
QUIET = YES
WARN_AS_ERROR = FAIL_ON_WARNINGS
WARN_IF_UNDOCUMENTED = NO
INPUT = $(tests/tools/public_headers.sh "$2" | tr '\n' ' ')
FILTER_PATTERNS = "*.h=awk -f tests/tools/doxygen.awk"
HAVE_DOT = NO
MARKDOWN_SUPPORT = YES
OPTIMIZE_OUTPUT_FOR_C = YES
EXTRACT_ALL = YES
EXTRACT_STATIC = YES
JAVADOC_AUTOBRIEF = YES
SORT_MEMBER_DOCS = NO
SHOW_USED_FILES = NO
HIDE_UNDOC_RELATIONS = YES
ENABLE_PREPROCESSING = YES
MACRO_EXPANSION = YES
EXPAND_ONLY_PREDEF = YES
SEARCH_INCLUDES = NO
PREDEFINED = PEL_BEGIN_DECLS= PEL_END_DECLS= PEL_HOT=inline \
    PEL_ALWAYS_INLINE=inline PEL_INLINE_64=inline "__attribute__(x)="
END
