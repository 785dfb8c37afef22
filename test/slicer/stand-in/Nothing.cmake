# Slicer writes the extension's description and makes a package here.
