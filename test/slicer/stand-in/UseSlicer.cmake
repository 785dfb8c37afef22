set(EXTENSION_NAME ${PROJECT_NAME})

function(mark_as_superbuild)
endfunction()
