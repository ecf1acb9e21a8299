-- The gallery: all games that come with Fettle, each with a picture of itself. `fettle run` without a path opens it.

-- Functions of the host, which only this game gets. Elsewhere, in a test for instance, there is nothing to open.
local host_games, host_show, host_open =
    rawget(_G, "gallery_games"), rawget(_G, "gallery_show"), rawget(_G, "open_game")

local margin, gap = 40, 28                    -- px
local widest_card, text_room = 400, 74        -- px
local card_color, chosen_color = color("#242b38"), color("#32405a")
local edge_color, chosen_edge = color("#3a4456"), color("#7fb2ff")

game.gallery = Object { chosen = 1, scroll = 0.0 }

local games = {}
for i, entry in ipairs(host_games and host_games() or {}) do
    games[i] = { name = entry[1], title = entry[2], about = entry[3] }
end

-- Lines of at most so many characters, and their number.
local function wrapped(text, most, lines)
    local out, line = {}, ""
    for word in text:gmatch("%S+") do
        if #line + #word + 1 > most and line ~= "" then
            out[#out + 1], line = line, word
        else
            line = line == "" and word or line .. " " .. word
        end
    end
    out[#out + 1] = line
    if #out > lines then out[lines] = out[lines] .. " ..." end
    local count = math.min(lines, #out)
    return table.concat(out, "\n", 1, count), count
end

local function help()
    local text = #games > 0 and
        "Click a game, or choose it with the arrow keys and Enter, or a stick and A. To come back here, hold Escape or the back button." or
        "There are no games here: open the gallery with fettle run."
    return wrapped(text, (view.screen.x - 2 * margin) // 8.5, 6)
end

-- Where the cards begin, px.
local function top()
    local _, lines = help()
    return 91 + 19 * lines
end

local function columns()
    return math.max(1, math.ceil((view.screen.x - 2 * margin) / (widest_card + gap)))
end

-- Left, top, width of a card, and the height of the picture in it, px.
local function place_of(index)
    local count = columns()
    local width = (view.screen.x - 2 * margin - (count - 1) * gap) / count
    local picture = width * 0.625
    local column, row = (index - 1) % count, (index - 1) // count
    return margin + column * (width + gap), top() + row * (picture + text_room + gap) - gallery.scroll, width, picture
end

local function card_at(point)
    for i in ipairs(games) do
        local left, upper, width, picture = place_of(i)
        if point.x >= left and point.x <= left + width and point.y >= upper and point.y <= upper + picture + text_room then
            return i
        end
    end
end

local function lowest_scroll()
    if #games == 0 then return 0 end
    local _, upper, _, picture = place_of(#games)
    return math.max(0, upper + gallery.scroll + picture + text_room + margin - view.screen.y)
end

local function scroll_to(where)
    gallery.scroll = math.max(0.0, math.min(lowest_scroll() + 0.0, where + 0.0))
end

-- Of a card that is higher than the window, the upper part.
local function show_chosen()
    local _, upper, _, picture = place_of(gallery.chosen)
    local over = upper + picture + text_room + margin - view.screen.y
    scroll_to(gallery.scroll + math.min(upper - top(), math.max(0, over)))
end

local function open(index)
    if not games[index] or not host_open then return end
    store.opened = games[index].name
    host_open(games[index].name)
end

-- Who comes back finds the game that was opened.
function start()
    view.background = color("#171c26")
    for i, entry in ipairs(games) do
        if entry.name == store.opened then gallery.chosen = i end
    end
    if #games > 0 then show_chosen() end
end

function mouse_moved(_, point)
    gallery.chosen = card_at(point) or gallery.chosen
end

function mouse_pressed(button, _, point)
    if button == "left" then open(card_at(point)) end
end

function wheel(notches)
    scroll_to(gallery.scroll - notches * 60)
end

local function move_by(count)
    if #games == 0 then return end
    gallery.chosen = math.max(1, math.min(#games, gallery.chosen + count))
    show_chosen()
end

local moves = {
    left = function() return -1 end,
    right = function() return 1 end,
    up = function() return -columns() end,
    down = columns,
}

function key_pressed(key)
    if moves[key] then
        move_by(moves[key]())
    elseif key == "enter" or key == "space" then
        open(gallery.chosen)
    elseif key == "escape" then
        quit()
    end
end

input.actions.choose = { "gamepad.left", "gamepad.pad" }
input.actions.open = { "gamepad.a", "gamepad.start" }

function action_pressed(action)
    local way = input.choose.direction
    if action == "open" then
        open(gallery.chosen)
    elseif math.abs(way.x) > math.abs(way.y) then
        move_by(way.x > 0 and 1 or -1)
    else
        move_by(way.y > 0 and -columns() or columns())
    end
end

local function draw_card(pen, index, card)
    local left, upper, width, picture = place_of(index)
    if upper > view.screen.y or upper + picture + text_room < 0 then return end
    local chosen = index == gallery.chosen
    pen.box(vec(left + width / 2, upper + (picture + text_room) / 2), width, picture + text_room,
        chosen and chosen_color or card_color, chosen and chosen_edge or edge_color, chosen and 3 or 1.5)
    pen.text(vec(left + width / 2, upper + picture / 2), "...", 24, edge_color)
    if host_show then host_show(card.name, left + 4, upper + 4, width - 8, picture - 4, top() - 14) end
    pen.text(vec(left + 14, upper + picture + 20), card.title, 20, "white", "left")
    pen.text(vec(left + 14, upper + picture + 50), (wrapped(card.about, width // 7, 2)), 13, color("#a0a8b8"), "left")
end

function draw(pen)
    pen.screen(function()
        for i, card in ipairs(games) do draw_card(pen, i, card) end
        local height = top() - 14
        pen.box(vec(view.screen.x / 2, height / 2), view.screen.x, height, view.background)
        pen.text(vec(margin, 40), "Fettle", 36, "white", "left")
        local text, lines = help()
        pen.text(vec(margin, 66.5 + 9.5 * lines), text, 16, color("#a0a8b8"), "left")
    end)
end
