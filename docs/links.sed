# Doxygen finds pictures by name and pages of Markdown without anchors. Sources and folders are no part of the site.
s#!\[\([^]]*\)\](\([^)]*/\)\{0,1\}\([^/)]*\.png\))#![\1](\3)#g
s#\(\.md\)\#[-a-z0-9]*)#\1)#g
s#\[\([^]]*\)\]([^):]*\.\(py\|sh\|h\|cxx\))#\1#g
s#\[\([^]]*\)\](\(\.\./\)*[-A-Za-z0-9_/]*)#\1#g
