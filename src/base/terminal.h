#pragma once

namespace candela {

/// Whether stderr is a terminal whose lines can be redrawn: not a file, a pipe or TERM=dumb.
bool IsErrorTerminal();

/// Characters in a line of the terminal behind stderr; 80 where the system does not tell.
int ErrorTerminalColumns();

/// Whether the user asks for text without colours: NO_COLOR is set and not empty (no-color.org).
bool AreColoursUnwanted();

}  // namespace candela
