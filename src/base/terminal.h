#pragma once

namespace candela {

/// Whether stderr is a terminal whose lines can be redrawn: not a file, a pipe or TERM=dumb.
bool IsErrorTerminal();

/// Characters in a line of the terminal behind stderr; 80 where the system does not tell.
int ErrorTerminalColumns();

/// Says whether the cursor stands inside a line of stderr that will be redrawn.
void MarkOpenLine(bool is_open);

/// Ends such a line, so that what comes next begins a new one. Async-signal-safe: meant for
/// handlers that end the process.
void EndOpenLine() noexcept;

/// Whether the user asks for text without colours: NO_COLOR is set and not empty (no-color.org).
bool AreColoursUnwanted();

}  // namespace candela
